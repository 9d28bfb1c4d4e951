#include "Correspondence/Transport/GromovWassersteinCoupling.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Correspondence/Transport/Private/Sinkhorn.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// 0 log 0 is 0.
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
  RequireCouplingOptions(options);
  if (spaces.WeightsA.size() == 0 || spaces.WeightsB.size() == 0 ||
    start.rows() != spaces.WeightsA.size() || start.cols() != spaces.WeightsB.size() ||
    !(spaces.WeightsA.minCoeff() > 0.0 && spaces.WeightsB.minCoeff() > 0.0))
  {
    throw InvalidInput("samples must have positive weights, and the start must have a row for each "
                       "sample of A and a column for each sample of B");
  }
}

void CheckCosts(const MetricSpaces& spaces)
{
  RequireOption(spaces.CostWeight >= 0.0 && spaces.CostWeight <= 1.0, "FeatureWeight",
    spaces.CostWeight, "between 0 and 1");
  if (spaces.Costs.size() > 0 &&
    (spaces.Costs.rows() != spaces.WeightsA.size() ||
      spaces.Costs.cols() != spaces.WeightsB.size() || !spaces.Costs.allFinite()))
  {
    throw InvalidInput("costs must be finite and have a row for each sample of A and a column for "
                       "each sample of B");
  }
}

/// Couples the samples of fixed pairs to each other only.
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

/// How much the objective of SolveCoupling, without the entropy, falls with each mass, for gains
/// DistancesA P DistancesB of the present masses P: (1 - w) gains - w Costs / 4.
Eigen::MatrixXd PullOf(const MetricSpaces& spaces, const Eigen::MatrixXd& gains)
{
  return spaces.Costs.size() > 0
    ? (1.0 - spaces.CostWeight) * gains - 0.25 * spaces.CostWeight * spaces.Costs
    : gains;
}

/// Masses, the values from which they were computed, and those for the next masses. Gains: DA P DB.
/// Pull: how much the objective falls with each mass.
struct State
{
  Eigen::MatrixXd Likeness, Masses, Gains, Pull;
  Sinkhorn Scaling;
};

} // namespace

void RequireCouplingOptions(const EntropicCouplingOptions& options)
{
  RequireOption(
    std::isfinite(options.FirstEntropy), "FirstEntropy", options.FirstEntropy, "a finite number");
  RequireOption(options.Entropy > 0.0, "Entropy", options.Entropy, "positive");
  RequireOption(options.FirstEntropy >= options.Entropy, "FirstEntropy", options.FirstEntropy,
    "at least Entropy");
  RequireOption(options.EntropyFactor > 0.0 && options.EntropyFactor < 1.0, "EntropyFactor",
    options.EntropyFactor, "between 0 and 1");
  RequireOption(options.IterationsPerEntropy >= 1, "IterationsPerEntropy",
    options.IterationsPerEntropy, "at least 1");
  RequireOption(options.SinkhornIterations >= 1, "SinkhornIterations", options.SinkhornIterations,
    "at least 1");
  RequireOption(options.Tolerance > 0.0, "Tolerance", options.Tolerance, "positive");
}

void Normalize(MetricSpaces& spaces, int pairs)
{
  const double longest = std::max(spaces.DistancesA.maxCoeff(), spaces.DistancesB.maxCoeff());
  spaces.DistancesA /= longest;
  spaces.DistancesB /= longest;
  const Eigen::VectorXd means = 0.5 * (spaces.WeightsA.head(pairs) + spaces.WeightsB.head(pairs));
  for (Eigen::VectorXd* weights : { &spaces.WeightsA, &spaces.WeightsB })
  {
    const Eigen::Index others = weights->size() - pairs;
    weights->tail(others) *= (1.0 - means.sum()) / weights->tail(others).sum();
    weights->head(pairs) = means;
  }
}

// Solomon et al., algorithm 1, with continuation in the entropy:
// 1. The gains of the last masses: DA P DB.
// 2. The next masses by Sinkhorn's iteration on exp(gains / e), damped if the objective rose.
// 3. Repeat until the objective stays, then lower e and continue from these masses.
EntropicCoupling SolveCoupling(const MetricSpaces& spaces, const Eigen::MatrixXd& start,
  const Landmarks& fixed, const EntropicCouplingOptions& options, const Progress& progress)
{
  Check(spaces, start, options);
  CheckCosts(spaces);
  const bool isFused = spaces.Costs.size() > 0;
  const double ofCosts = isFused ? spaces.CostWeight : 0.0, ofDistances = 1.0 - ofCosts;
  const Eigen::VectorXd &rows = spaces.WeightsA, &columns = spaces.WeightsB;
  const BlasThreads several(
    BlasThreads::WorthSharing(static_cast<int>(std::min(rows.size(), columns.size()))));
  // The part of the objective that depends only on the weights: sum (a - b)^2 = sum a^2 + sum b^2 -
  // 2 sum a b, and the sums of squares are fixed by the marginals.
  const double own = rows.dot(spaces.DistancesA.cwiseAbs2() * rows) +
    columns.dot(spaces.DistancesB.cwiseAbs2() * columns);
  const auto follow = [&](const State& from, Eigen::MatrixXd likeness, const Progress& part)
  {
    State next{ std::move(likeness), {}, {}, {}, from.Scaling };
    Fix(fixed, next.Likeness);
    next.Masses = next.Scaling.Masses(
      next.Likeness, options.SinkhornIterations, options.Tolerance, part.Part(0.0, 0.5));
    const Eigen::MatrixXd ofA = spaces.DistancesA * next.Masses;
    part(0.75);
    next.Gains = ofA * spaces.DistancesB;
    next.Pull = PullOf(spaces, next.Gains);
    return next;
  };
  EntropicCoupling coupling;
  State state = follow({ {}, {}, {}, {}, Sinkhorn(rows, columns) }, start, progress.Part(0.0, 0.0));
  // The small number keeps an exact power of EntropyFactor from costing one more level by rounding.
  const double span =
    std::log(options.Entropy / options.FirstEntropy) / std::log(options.EntropyFactor);
  const int levels = 1 + static_cast<int>(std::ceil(span - 1e-9));
  double last = options.FirstEntropy;
  for (int level = 0; level < levels; ++level)
  {
    const double entropy =
      std::max(options.Entropy, options.FirstEntropy * std::pow(options.EntropyFactor, level));
    // The logarithms are gains / e, so a new e only scales them, and Sinkhorn's factors with them.
    state.Likeness *= last / entropy;
    state.Scaling.Scale(last / entropy);
    last = entropy;
    double before = std::numeric_limits<double>::infinity(), power = 1.0;
    for (int iteration = 0; iteration < options.IterationsPerEntropy; ++iteration)
    {
      // Sinkhorn's iterations become more as the entropy falls.
      const auto reached = [&](int iterations)
      {
        return std::pow(
          (level + static_cast<double>(iterations) / options.IterationsPerEntropy) / levels, 2.0);
      };
      const Progress part = progress.Part(reached(iteration), reached(iteration + 1));
      // The paper's damping: P^(1 - eta) times the new masses to the power eta, a weighted mean of
      // logarithms.
      State next = power < 1.0
        ? follow(state, power / entropy * state.Pull + (1.0 - power) * state.Likeness, part)
        : follow(state, state.Pull / entropy, part);
      const double objective =
        ofDistances * (0.25 * own - 0.5 * next.Masses.cwiseProduct(next.Gains).sum()) +
        (isFused ? 0.25 * ofCosts * next.Masses.cwiseProduct(spaces.Costs).sum() : 0.0) +
        entropy * RelativeEntropy(next.Masses, rows, columns);
      constexpr double enough = 1e-5, little = 1e-3; // of the objective
      if (objective > before)
      {
        // Converged: the rise is within Sinkhorn's tolerance.
        if (objective < before + little * std::abs(before) || power < 0.2)
        {
          break;
        }
        power *= 0.5;
        continue;
      }
      state = std::move(next);
      coupling.Objectives.push_back(objective);
      coupling.Entropies.push_back(entropy);
      if (before - objective < enough * std::abs(objective))
      {
        break;
      }
      before = objective;
    }
  }
  coupling.Error = state.Scaling.Error();
  const Eigen::VectorXd ofA = state.Masses.rowwise().sum(), ofB = state.Masses.colwise().sum();
  // With the masses' own marginals, which differ from the weights by Error; otherwise the sum could
  // be negative.
  const double squares = ofA.dot(spaces.DistancesA.cwiseAbs2() * ofA) +
    ofB.dot(spaces.DistancesB.cwiseAbs2() * ofB) -
    2.0 * state.Masses.cwiseProduct(state.Gains).sum();
  coupling.Distortion = std::sqrt(std::max(0.0, squares));
  coupling.Cost = isFused ? state.Masses.cwiseProduct(spaces.Costs).sum() : 0.0;
  coupling.Masses = std::move(state.Masses);
  // Of the total mass. If more of it does not fit the weights, the coupling describes no map.
  constexpr double maximum = 0.05;
  if (coupling.Error > maximum)
  {
    throw SolveFailure("the coupling of " + std::to_string(rows.size()) +
      " samples did not converge: " + std::to_string(coupling.Error) +
      " of the mass does not fit their weights; give more landmarks or fewer samples");
  }
  progress(1.0);
  return coupling;
}

EntropicCoupling RefineCoupling(const MetricSpaces& spaces, const Eigen::MatrixXd& masses,
  const Landmarks& fixed, EntropicCouplingOptions options, const Progress& progress)
{
  constexpr double more = 8.0; // factor of the last entropy
  options.FirstEntropy = std::min(options.FirstEntropy, more * options.Entropy);
  const Eigen::MatrixXd gains =
    spaces.DistancesA.leftCols(masses.rows()) * masses * spaces.DistancesB.topRows(masses.cols());
  return SolveCoupling(
    spaces, PullOf(spaces, gains) / options.FirstEntropy, fixed, options, progress);
}

} // namespace shape
