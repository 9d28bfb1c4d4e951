#include "Harmonic/RadialBasisField.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Mesh/Mesh.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace shape
{

namespace
{

using KernelType = RadialBasisOptions::KernelType;

/// Returns the basis functions of the squared distances, relative to the radius.
template <KernelType Kernel>
Eigen::ArrayXd RadialValues(const Eigen::ArrayXd& squares)
{
  if constexpr (Kernel == KernelType::Wendland)
  {
    const Eigen::ArrayXd r = squares.sqrt().min(1.0);
    return (1.0 - r).square().square() * (4.0 * r + 1.0);
  }
  // At a centre, r^2 log r is 0.
  return 0.5 * squares * squares.max(1e-300).log();
}

/// Returns the values of the basis functions at one point, one for each centre.
Eigen::ArrayXd RadialRow(
  KernelType kernel, double radius, const Eigen::MatrixXd& centres, const Eigen::RowVector3d& point)
{
  const Eigen::ArrayXd squares =
    (centres.rowwise() - point).rowwise().squaredNorm().array() / (radius * radius);
  return kernel == KernelType::Wendland ? RadialValues<KernelType::Wendland>(squares)
                                        : RadialValues<KernelType::ThinPlate>(squares);
}

Eigen::MatrixXd PolynomialRows(const Eigen::MatrixXd& points)
{
  Eigen::MatrixXd rows(points.rows(), 4);
  rows << Eigen::VectorXd::Ones(points.rows()), points;
  return rows;
}

/// Sets the weights and adds to the affine part such that the field has the given values at its
/// centres. The weights are orthogonal to affine functions.
void Interpolate(RadialBasisField& field, const Eigen::MatrixXd& values)
{
  const Eigen::Index count = field.Centres.rows();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + 4, count + 4);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    matrix.col(i).head(count) =
      RadialRow(field.Kernel, field.Radius, field.Centres, field.Centres.row(i));
  }
  matrix.topRightCorner(count, 4) = PolynomialRows(field.Centres);
  matrix.bottomLeftCorner(4, count) = matrix.topRightCorner(count, 4).transpose();
  Eigen::MatrixXd rightSide = Eigen::MatrixXd::Zero(count + 4, 3);
  rightSide.topRows(count) = values;
  const Eigen::MatrixXd solution = matrix.partialPivLu().solve(rightSide);
  if (!solution.allFinite())
  {
    throw SolveFailure("the system of the radial basis functions is singular; raise Tolerance, or "
                       "use the Method Harmonic");
  }
  field.Weights = solution.topRows(count);
  field.Affine.col(3) = solution.row(count).transpose();
  field.Affine.leftCols<3>() = solution.bottomRows(3).transpose();
}

/// Returns up to `count` rows with the largest errors, largest first; any two of them are farther
/// apart than `spacing`.
std::vector<int> FarApartLargest(
  const Eigen::MatrixXd& points, const Eigen::VectorXd& errors, int count, double spacing)
{
  std::vector<int> order(errors.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return errors(a) > errors(b); });
  std::vector<int> chosen;
  for (const int row : order)
  {
    if (static_cast<int>(chosen.size()) == count || !(errors(row) > 0.0))
    {
      break;
    }
    if (std::all_of(chosen.begin(), chosen.end(),
          [&](int other) { return (points.row(other) - points.row(row)).norm() > spacing; }))
    {
      chosen.push_back(row);
    }
  }
  return chosen;
}

/// Returns up to `count` different points: the first one, and repeatedly the farthest from those.
std::vector<int> FirstCentres(const Eigen::MatrixXd& points, int count)
{
  std::vector<int> chosen = { 0 };
  Eigen::VectorXd distances = (points.rowwise() - points.row(0)).rowwise().squaredNorm();
  while (static_cast<int>(chosen.size()) < count)
  {
    Eigen::Index next = 0;
    if (!(distances.maxCoeff(&next) > 0.0))
    {
      break;
    }
    chosen.push_back(static_cast<int>(next));
    distances =
      distances.cwiseMin((points.rowwise() - points.row(next)).rowwise().squaredNorm()).eval();
  }
  return chosen;
}

} // namespace

Eigen::MatrixXd Evaluate(
  const RadialBasisField& field, const Eigen::MatrixXd& points, const Progress& progress)
{
  Eigen::MatrixXd values = points.lazyProduct(field.Affine.leftCols<3>().transpose());
  values.rowwise() += field.Affine.col(3).transpose();
  if (field.Centres.rows() == 0)
  {
    return values;
  }
  ParallelFor(
    static_cast<int>(points.rows()), 256,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        values.row(i) +=
          RadialRow(field.Kernel, field.Radius, field.Centres, points.row(i)).matrix().transpose() *
          field.Weights;
      }
    },
    progress);
  return values;
}

void RequireValid(const RadialBasisOptions& options)
{
  RequireOption(options.SupportRadius > 0.0 && std::isfinite(options.SupportRadius),
    "SupportRadius", options.SupportRadius, "positive and finite");
  RequireOption(options.Tolerance >= 0.0 && std::isfinite(options.Tolerance), "Tolerance",
    options.Tolerance, "at least 0 and finite");
  RequireOption(
    options.MaximumCentres >= 1, "MaximumCentres", options.MaximumCentres, "at least 1");
}

RadialBasisField FitRadialBasis(const Eigen::MatrixXd& points, const Eigen::MatrixXd& values,
  const RadialBasisOptions& options, const Progress& progress)
{
  // Outline:
  // 1. The affine part, by least squares. If it fits, there are no centres.
  // 2. Far points are the first centres.
  // 3. Each round interpolates at the centres, and adds half as many where the errors are largest.
  RequireValid(options);
  constexpr int first = 16;
  constexpr double rounding = 1e-12;
  // Relative to the box, so that the system has a good scale.
  const Eigen::RowVector3d origin = points.colwise().minCoeff();
  const double longest = ComputeLongestBoxEdge(points), size = longest > 0.0 ? longest : 1.0;
  const Eigen::MatrixXd scaled = (points.rowwise() - origin) / size;
  const double largest = values.rowwise().norm().maxCoeff();
  RadialBasisField field;
  field.Kernel = options.Kernel;
  field.Radius = options.Kernel == KernelType::Wendland ? options.SupportRadius : 1.0;
  const Eigen::MatrixXd polynomial = PolynomialRows(scaled);
  const Eigen::MatrixXd affine = polynomial.completeOrthogonalDecomposition().solve(values);
  const Eigen::MatrixXd rest = values - polynomial * affine;
  Eigen::VectorXd errors = rest.rowwise().norm();
  if (errors.maxCoeff() > rounding * largest)
  {
    std::vector<int> centres = FirstCentres(scaled, std::min(first, options.MaximumCentres));
    for (;;)
    {
      const auto count = static_cast<int>(centres.size());
      // The share of the work grows with the cube of the number of centres.
      const double share = std::pow(static_cast<double>(count) / options.MaximumCentres, 2);
      progress(std::min(0.99, share));
      field.Centres = scaled(centres, Eigen::all);
      Interpolate(field, rest(centres, Eigen::all));
      errors = (rest - Evaluate(field, scaled)).rowwise().norm();
      if (errors.maxCoeff() <= options.Tolerance * largest || count >= options.MaximumCentres)
      {
        break;
      }
      const int more = std::min(options.MaximumCentres - count, std::max(8, count / 2));
      // At a centre the error is only rounding.
      errors(centres).setZero();
      const std::vector<int> worst =
        FarApartLargest(scaled, errors, more, 0.5 / std::sqrt(static_cast<double>(count)));
      if (worst.empty())
      {
        break;
      }
      centres.insert(centres.end(), worst.begin(), worst.end());
    }
  }
  field.MaximumError = largest > 0.0 ? errors.maxCoeff() / largest : 0.0;
  // The coordinates of the input.
  field.Affine.col(3) += affine.row(0).transpose();
  field.Affine.leftCols<3>() += affine.bottomRows(3).transpose();
  field.Affine.leftCols<3>() /= size;
  field.Affine.col(3) -= field.Affine.leftCols<3>() * origin.transpose();
  field.Centres = (field.Centres * size).rowwise() + origin;
  field.Radius *= size;
  progress(1.0);
  return field;
}

} // namespace shape
