#include "Correspondence/GromovWassersteinCoupling.h"

#include "Core/Errors.h"
#include "Core/Parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shape
{
namespace
{

/// Adds to each column what makes its exponentials add up to the column's weight.
void FitColumns(Eigen::MatrixXd& likeness, const Eigen::VectorXd& weights)
{
  for (Eigen::Index j = 0; j < likeness.cols(); ++j)
  {
    const double largest = likeness.col(j).maxCoeff();
    const double sum = (likeness.col(j).array() - largest).exp().sum();
    likeness.col(j).array() += std::log(weights(j)) - largest - std::log(sum);
  }
}

/// The same of rows.
void FitRows(Eigen::MatrixXd& likeness, const Eigen::VectorXd& weights)
{
  const Eigen::VectorXd largest = likeness.rowwise().maxCoeff();
  likeness.colwise() -= largest;
  const Eigen::ArrayXd sums = likeness.array().exp().rowwise().sum();
  likeness.colwise() += (weights.array().log() - sums.log()).matrix();
}

double RelativeEntropy(
  const Eigen::MatrixXd& masses, const Eigen::VectorXd& rows, const Eigen::VectorXd& columns)
{
  double sum = 0.0;
  for (Eigen::Index j = 0; j < masses.cols(); ++j)
  {
    for (Eigen::Index i = 0; i < masses.rows(); ++i)
    {
      const double mass = masses(i, j);
      sum += mass > 0.0 ? mass * std::log(mass / (rows(i) * columns(j))) : 0.0;
    }
  }
  return sum;
}

void Check(
  const MetricSpaces& spaces, const Eigen::MatrixXd& start, const EntropicCouplingOptions& options)
{
  RequireOption(options.Entropy > 0.0, "Entropy", options.Entropy, "positive");
  RequireOption(options.FirstEntropy >= options.Entropy, "FirstEntropy", options.FirstEntropy,
    "at least Entropy");
  RequireOption(
    options.Factor > 0.0 && options.Factor < 1.0, "Factor", options.Factor, "between 0 and 1");
  RequireOption(options.Iterations >= 1, "Iterations", options.Iterations, "at least 1");
  RequireOption(options.SinkhornIterations >= 1, "SinkhornIterations", options.SinkhornIterations,
    "at least 1");
  RequireOption(options.Tolerance > 0.0, "Tolerance", options.Tolerance, "positive");
  if (spaces.WeightsA.size() == 0 || spaces.WeightsB.size() == 0 ||
    start.rows() != spaces.WeightsA.size() || start.cols() != spaces.WeightsB.size() ||
    !(spaces.WeightsA.minCoeff() > 0.0 && spaces.WeightsB.minCoeff() > 0.0))
  {
    throw InvalidInput("places must have positive weights, and the start a row for each of A and "
                       "a column for each of B");
  }
}

/// Lets the places of fixed pairs go nowhere else.
void Fix(const Landmarks& fixed, Eigen::MatrixXd& likeness)
{
  for (const auto& [i, j] : fixed)
  {
    const double own = likeness(i, j);
    likeness.row(i).setConstant(-std::numeric_limits<double>::infinity());
    likeness.col(j).setConstant(-std::numeric_limits<double>::infinity());
    likeness(i, j) = own;
  }
}

} // namespace

Eigen::MatrixXd SinkhornMasses(const Eigen::MatrixXd& likeness, const Eigen::VectorXd& rows,
  const Eigen::VectorXd& columns, int iterations, double tolerance)
{
  // Logarithms are shifted into the range of numbers now and then; between, factors do.
  constexpr int span = 25;
  constexpr double tiny = 1e-100;
  Eigen::MatrixXd shifted = likeness, masses;
  for (int done = 0;;)
  {
    FitRows(shifted, rows);
    FitColumns(shifted, columns);
    masses = shifted.array().exp();
    Eigen::VectorXd ofRows = Eigen::VectorXd::Ones(rows.size()),
                    ofColumns = Eigen::VectorXd::Ones(columns.size());
    for (int k = 0; k < span && done < iterations; ++k, ++done)
    {
      const Eigen::VectorXd sums = masses * ofColumns;
      if ((sums.cwiseProduct(ofRows) - rows).cwiseAbs().sum() < tolerance)
      {
        done = iterations;
        break;
      }
      ofRows = rows.cwiseQuotient(sums.cwiseMax(tiny));
      ofColumns = columns.cwiseQuotient((masses.transpose() * ofRows).cwiseMax(tiny));
    }
    if (done >= iterations)
    {
      return ofRows.asDiagonal() * masses * ofColumns.asDiagonal();
    }
    shifted.colwise() += ofRows.array().log().matrix();
    shifted.rowwise() += ofColumns.array().log().matrix().transpose();
  }
}

EntropicCoupling FindCoupling(const MetricSpaces& spaces, const Eigen::MatrixXd& start,
  const Landmarks& fixed, const EntropicCouplingOptions& options, const Progress& progress)
{
  Check(spaces, start, options);
  const Eigen::VectorXd &rows = spaces.WeightsA, &columns = spaces.WeightsB;
  const BlasThreads several(
    BlasThreads::WorthSharing(static_cast<int>(std::min(rows.size(), columns.size()))));
  const double own = rows.dot(spaces.DistancesA.cwiseAbs2() * rows) +
    columns.dot(spaces.DistancesB.cwiseAbs2() * columns);
  EntropicCoupling coupling;
  Eigen::MatrixXd& masses = coupling.Masses;
  Eigen::MatrixXd likeness = start;
  Fix(fixed, likeness);
  masses = SinkhornMasses(likeness, rows, columns, options.SinkhornIterations, options.Tolerance);
  Eigen::MatrixXd gains = spaces.DistancesA * masses * spaces.DistancesB;
  const double span = std::log(options.Entropy / options.FirstEntropy) / std::log(options.Factor);
  const int levels = 1 + static_cast<int>(std::ceil(span - 1e-9));
  for (int level = 0; level < levels; ++level)
  {
    const double entropy =
      std::max(options.Entropy, options.FirstEntropy * std::pow(options.Factor, level));
    double before = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < options.Iterations; ++iteration)
    {
      progress((level + static_cast<double>(iteration) / options.Iterations) / levels);
      likeness = gains / entropy;
      Fix(fixed, likeness);
      masses =
        SinkhornMasses(likeness, rows, columns, options.SinkhornIterations, options.Tolerance);
      gains = spaces.DistancesA * masses * spaces.DistancesB;
      const double objective = 0.25 * own - 0.5 * masses.cwiseProduct(gains).sum() +
        entropy * RelativeEntropy(masses, rows, columns);
      coupling.Objectives.push_back(objective);
      coupling.Entropies.push_back(entropy);
      constexpr double enough = 1e-5; // of the objective, that an iteration gains
      if (before - objective < enough * std::abs(objective))
      {
        break;
      }
      before = objective;
    }
  }
  progress(1.0);
  return coupling;
}

} // namespace shape
