#include "Fmm/FmmSummation.h"

#include "Base/Errors.h"
#include "Fmm/DirectSummation.h"
#include "Fmm/Private/FmmEvaluation.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <variant>

namespace shape
{

namespace
{

/// The minimum tolerance for which the box expansions can be in single precision.
constexpr double MinimumSingle = 9e-7;

/// Parameters that meet a tolerance, and their cost in pairs of the direct sum. Measured on
/// surfaces, volumes and graded clusters, with charges of one sign and of both.
struct Grade
{
  double Tolerance = 0.0;
  FmmEffort Effort;
  double SetUp = 0.0;    ///< cost of the operators
  double PerPoint = 0.0; ///< cost for each source and for each point
};

constexpr RootError Small = RootError::Small, Rounding = RootError::Rounding;
const Grade Grades[] = {
  { 1e-3, { { 4, 4, 1e-3, 1e-3 }, Small, Small, 64 }, 3e7, 700 },
  { 1e-4, { { 4, 4, 1e-4, 1e-4 }, Small, Small, 80 }, 3e7, 800 },
  { 1e-5, { { 6, 6, 1e-6, 5e-6 }, Small, Small, 100 }, 6e7, 1400 },
  { 1e-6, { { 6, 8, 5e-7, 1e-6 }, Small, Small, 140 }, 7e7, 2000 },
  { 1e-7, { { 8, 10, 2e-8, 7e-8 }, Rounding, Rounding, 200 }, 1e8, 4000 },
  { 1e-8, { { 8, 10, 2e-9, 5e-9 }, Rounding, Rounding, 200 }, 1.2e8, 6000 },
  { 1e-9, { { 10, 12, 1e-10, 7e-10 }, Rounding, Rounding, 300 }, 4e8, 7000 },
  { 1e-10, { { 12, 14, 1e-11, 7e-11 }, Rounding, Rounding, 400 }, 9e8, 10000 },
  { 1e-11, { { 14, 16, 1e-12, 7e-12 }, Rounding, Rounding, 500 }, 2e9, 13000 },
  { FmmSummationOptions::MinimumTolerance, { { 14, 16, 1e-13, 1e-12 }, Rounding, Rounding, 500 },
    2e9, 17500 },
};

/// Returns the first grade that meets the tolerance.
const Grade& GradeFor(double tolerance)
{
  // Grades are sorted by descending tolerance.
  const Grade* grade = std::begin(Grades);
  while (grade + 1 < std::end(Grades) && grade->Tolerance > tolerance)
  {
    ++grade;
  }
  return *grade;
}

void Check(const Eigen::MatrixXd& positions, const char* name)
{
  if (positions.cols() != 3 || !positions.allFinite())
  {
    throw InvalidInput(std::string("the ") + name +
      " of the sum must have three finite coordinates each; remove those that do not");
  }
}

} // namespace

struct FmmSummation::Parts
{
  struct Positions
  {
    Eigen::MatrixXd Sources, Points;
  };
  std::variant<Positions, FmmEvaluation<float>, FmmEvaluation<double>> Method;
  Eigen::Index Sources = 0, Points = 0;
  SumDevice Device;

  Eigen::MatrixXd Sum(
    const Eigen::MatrixXd& charges, bool gradients, const Progress& progress) const;
};

FmmSummation::FmmSummation(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points,
  const FmmSummationOptions& options, const Progress& progress)
  : Self(std::make_unique<Parts>())
{
  using MethodType = FmmSummationOptions::MethodType;
  Check(sources, "sources");
  Check(points, "points");
  this->Self->Sources = sources.rows();
  this->Self->Points = points.rows();
  this->Self->Device = options.Device;
  if (!(options.Tolerance >= FmmSummationOptions::MinimumTolerance && options.Tolerance <= 0.1))
  {
    std::ostringstream number;
    number << options.Tolerance;
    throw InvalidInput("the tolerance of the sum is " + number.str() +
      "; give 2e-12 to 0.1, or use the direct method for a smaller error");
  }
  if (!(options.LargerBoxes >= 1.0 && std::isfinite(options.LargerBoxes)))
  {
    std::ostringstream number;
    number << options.LargerBoxes;
    throw InvalidInput("LargerBoxes is " + number.str() + "; it must be at least 1, and finite");
  }
  const Grade& grade = GradeFor(options.Tolerance);
  const double m = static_cast<double>(sources.rows());
  const double n = static_cast<double>(std::max(points.rows(), options.AllPoints));
  // Compares the costs of both methods, in pairs of the direct sum.
  const bool worth = m * n > grade.SetUp + grade.PerPoint * (m + n);
  if (sources.rows() == 0 || points.rows() == 0 || options.Method == MethodType::Direct ||
    (options.Method == MethodType::Automatic && !worth))
  {
    this->Self->Method = Parts::Positions{ sources, points };
    return;
  }
  FmmEffort effort = grade.Effort;
  effort.Leaf = static_cast<int>(std::min(effort.Leaf * options.LargerBoxes, 1e9));
  // In single precision the box expansions take half the memory, and a vector register holds twice
  // as many coefficients.
  if (options.Tolerance >= MinimumSingle)
  {
    this->Self->Method.emplace<1>(sources, points, effort, progress);
  }
  else
  {
    this->Self->Method.emplace<2>(sources, points, effort, progress);
  }
}

FmmSummation::~FmmSummation() = default;
FmmSummation::FmmSummation(FmmSummation&&) noexcept = default;
FmmSummation& FmmSummation::operator=(FmmSummation&&) noexcept = default;

Eigen::MatrixXd FmmSummation::Parts::Sum(
  const Eigen::MatrixXd& charges, bool gradients, const Progress& progress) const
{
  if (charges.rows() != this->Sources)
  {
    throw InvalidInput("there are " + std::to_string(charges.rows()) + " rows of charges for " +
      std::to_string(this->Sources) + " sources; give one row of charges for each source");
  }
  if (const auto* positions = std::get_if<Positions>(&this->Method))
  {
    return gradients
      ? SumGradientsDirectly(positions->Sources, charges, positions->Points, progress, this->Device)
      : SumPotentialsDirectly(positions->Sources, charges, positions->Points, RootError::Rounding,
          progress, this->Device);
  }
  const Eigen::Index values = gradients ? 3 : 1;
  Eigen::MatrixXd sums(this->Points, values * charges.cols());
  // The innermost loops take up to three columns of charges.
  for (Eigen::Index first = 0; first < charges.cols(); first += 3)
  {
    const Eigen::Index count = std::min<Eigen::Index>(3, charges.cols() - first);
    const Progress part = progress.Part(static_cast<double>(first) / charges.cols(),
      static_cast<double>(first + count) / charges.cols());
    const Eigen::MatrixXd group = charges.middleCols(first, count);
    auto to = sums.middleCols(values * first, values * count);
    if (const auto* single = std::get_if<FmmEvaluation<float>>(&this->Method))
    {
      to = single->Sum(group, gradients, this->Device, part);
    }
    else
    {
      to = std::get<FmmEvaluation<double>>(this->Method).Sum(group, gradients, this->Device, part);
    }
  }
  return sums;
}

Eigen::MatrixXd FmmSummation::Potentials(
  const Eigen::MatrixXd& charges, const Progress& progress) const
{
  return this->Self->Sum(charges, false, progress);
}

Eigen::MatrixXd FmmSummation::Gradients(
  const Eigen::MatrixXd& charges, const Progress& progress) const
{
  return this->Self->Sum(charges, true, progress);
}

} // namespace shape
