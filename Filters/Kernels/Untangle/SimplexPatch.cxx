#include "Untangle/SimplexPatch.h"

#include "Untangle/Private/FoldoverFreeProblem.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

constexpr double MinimumEpsilon = 1e-10;
/// By which chi of the least determinant falls from step to step.
constexpr double MinimumShare = 0.1, MaximumShare = 0.5;

/// The minimiser of the sum of |J|^2, from which garbage is untangled.
Eigen::Matrix3Xd Smoothest(const Eigen::Matrix3Xd& x, EnergyProblem& problem)
{
  // One step of the same method with an epsilon beside which every determinant is nothing.
  const EnergyProblem::Descent descent = problem.NewtonDirection(x, 1e100);
  Eigen::Matrix3Xd smooth = x;
  problem.Move(smooth, descent.Direction, 1.0);
  return smooth;
}

} // namespace

PatchResult MinimizeEnergy(Eigen::Matrix3Xd& x, EnergyProblem& problem, const PatchOptions& options,
  const Progress& progress)
{
  PatchResult result;
  result.Negative = problem.CountNegative(x);
  double epsilon = result.Negative > 0 ? options.FirstEpsilon : MinimumEpsilon;
  EnergyProblem::State state = problem.Evaluate(x, epsilon);
  if (result.Negative > 0 && options.FromSmoothest)
  {
    Eigen::Matrix3Xd smooth = Smoothest(x, problem);
    const EnergyProblem::State other = problem.Evaluate(smooth, epsilon);
    if (other.Energy < state.Energy)
    {
      x = std::move(smooth);
      state = other;
      result.Negative = problem.CountNegative(x);
    }
  }
  result.EnergyBefore = state.Energy;
  int further = 0;
  double share = MinimumShare;
  Eigen::Matrix3Xd trial;
  for (; result.Steps < options.MaximumSteps; ++result.Steps)
  {
    progress(static_cast<double>(result.Steps) / options.MaximumSteps);
    if (result.Negative == 0 && further >= options.FurtherSteps)
    {
      break;
    }
    further += result.Negative == 0;
    const auto descent = problem.NewtonDirection(x, epsilon);
    EnergyProblem::State next;
    double step = 1.0;
    for (; step > 1e-9; step *= 0.5)
    {
      trial = x;
      problem.Move(trial, descent.Direction, step);
      next = problem.Evaluate(trial, epsilon);
      const bool valid = epsilon > MinimumEpsilon || next.MinimumDeterminant > 0.0;
      if (valid && next.Energy <= state.Energy - 1e-4 * step * descent.Slope)
      {
        break;
      }
    }
    const bool moved = step > 1e-9 && descent.Slope > 0.0;
    const double gain = moved ? 1.0 - next.Energy / state.Energy : 0.0;
    if (moved)
    {
      x.swap(trial);
      state = next;
    }
    const double before = epsilon;
    // Whole steps that gain little mean that the minimiser for this epsilon is near: go faster.
    if (step == 1.0 && gain < 0.05)
    {
      share = std::min(1.3 * share, MaximumShare);
    }
    else if (step < 1.0)
    {
      share = std::max(0.5 * share, MinimumShare);
    }
    const double chi =
      (1.0 - std::max(gain, share)) * EllipticEnergy::Chi(state.MinimumDeterminant, epsilon);
    epsilon = EllipticEnergy::EpsilonFor(state.MinimumDeterminant, chi, MinimumEpsilon);
    result.Negative = problem.CountNegative(x);
    if (result.Negative == 0)
    {
      epsilon = MinimumEpsilon;
      if (before == epsilon && gain < options.LeastGain)
      {
        break;
      }
    }
    if (epsilon != before)
    {
      state = problem.Evaluate(x, epsilon);
    }
  }
  result.EnergyAfter = state.Energy;
  return result;
}

PatchResult MinimizeEnergy(Eigen::MatrixXd& points, const SimplexPatch& patch,
  const PointConstraint* constraint, const PatchOptions& options, const Progress& progress)
{
  FoldoverFreeProblem problem(points, patch, constraint);
  Eigen::Matrix3Xd x = problem.Start;
  const PatchResult result = MinimizeEnergy(x, problem, options, progress);
  for (std::size_t i = 0; i < patch.FreePoints.size(); ++i)
  {
    points.row(patch.FreePoints[i]) = x.col(static_cast<Eigen::Index>(i)).transpose();
  }
  return result;
}

} // namespace shape
