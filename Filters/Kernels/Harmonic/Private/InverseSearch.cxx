#include "Harmonic/Private/InverseSearch.h"

#include "Base/Parallel.h"

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shape
{

namespace
{

using Indices = std::vector<int>;

/// Returns |values - targets| of each row; infinite if it is not a number.
Eigen::VectorXd Misses(const Eigen::MatrixXd& values, const Eigen::MatrixXd& targets)
{
  const Eigen::VectorXd misses = (values - targets).rowwise().norm();
  return misses.array().isFinite().select(misses, std::numeric_limits<double>::infinity());
}

/// Returns the Newton steps at the active positions, at most maxStep long; zero if the derivative
/// is singular.
Eigen::MatrixXd NewtonSteps(const SearchedMap& map, const Search& search, const Indices& active,
  double maxStep, const Progress& progress)
{
  const Eigen::MatrixXd jacobians = map.Jacobians(search.Positions(active, Eigen::all), progress);
  Eigen::MatrixXd steps(active.size(), 3);
  for (std::size_t i = 0; i < active.size(); ++i)
  {
    const Eigen::Matrix3d jacobian = GetJacobian(jacobians, i);
    const Eigen::Vector3d rest =
      (search.Targets.row(active[i]) - search.Values.row(active[i])).transpose();
    Eigen::Vector3d step = jacobian.partialPivLu().solve(rest);
    const double length = step.norm();
    if (!std::isfinite(length))
    {
      step.setZero();
    }
    else if (length > maxStep)
    {
      step *= maxStep / length;
    }
    steps.row(i) = step.transpose();
  }
  return steps;
}

/// Fills one row for each point, in parallel.
template <typename Fill>
Eigen::MatrixXd ByPoint(
  const Eigen::MatrixXd& points, int columns, const Fill& fill, const Progress& progress)
{
  Eigen::MatrixXd rows(points.rows(), columns);
  ParallelFor(
    static_cast<int>(points.rows()), 32,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        fill(points.row(i).transpose(), rows.row(i));
      }
    },
    progress);
  return rows;
}

} // namespace

SearchedMap::SearchedMap(const PointCharges& map)
  : Evaluate(
      [&map](const Eigen::MatrixXd& points, const Progress& progress)
      {
        return ByPoint(
          points, 3,
          [&map](const Eigen::Vector3d& position, auto row)
          { row = map.Evaluate(position).transpose(); },
          progress);
      })
  , Jacobians(
      [&map](const Eigen::MatrixXd& points, const Progress& progress)
      {
        return ByPoint(
          points, 9,
          [&map](const Eigen::Vector3d& position, auto row)
          {
            Eigen::Matrix3d jacobian;
            map.Evaluate(position, jacobian);
            row << jacobian.row(0), jacobian.row(1), jacobian.row(2);
          },
          progress);
      })
{
}

SearchedMap::SearchedMap(const PiecewiseHarmonicMap& map)
  : Evaluate([&map](const Eigen::MatrixXd& points, const Progress& progress)
      { return map.Evaluate(points, progress); })
  , Jacobians([&map](const Eigen::MatrixXd& points, const Progress& progress)
      { return map.Jacobians(points, progress); })
{
}

Search StartSearch(const SearchedMap& map, const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& targets, const Progress& progress)
{
  Search search{ positions, targets, map.Evaluate(positions, progress), {} };
  search.Misses = Misses(search.Values, targets);
  return search;
}

void IterateNewton(const SearchedMap& map, Search& search, const Limits& limits, Steps& progress)
{
  // In one iteration the Newton steps of all active positions are computed. Each step is halved
  // until the miss decreases. Positions that meet the goal and gain little more are done.
  Indices active;
  for (int i = 0; i < search.Misses.size(); ++i)
  {
    if (std::isfinite(search.Misses(i)) && search.Misses(i) > 0.0)
    {
      active.push_back(i);
    }
  }
  for (int iteration = 0; iteration < limits.Iterations && !active.empty(); ++iteration)
  {
    const Eigen::MatrixXd steps = NewtonSteps(map, search, active, limits.MaxStep, progress.Next());
    Indices next, pending(active.size());
    for (std::size_t i = 0; i < pending.size(); ++i)
    {
      pending[i] = static_cast<int>(i);
    }
    // Armijo's rule: a step must decrease the miss by at least 1e-4 of what the linear model
    // predicts.
    double share = 1.0;
    for (int halving = 0; halving < 12 && !pending.empty(); ++halving, share *= 0.5)
    {
      Indices ids, farther;
      for (const int i : pending)
      {
        ids.push_back(active[i]);
      }
      const Eigen::MatrixXd positions =
        search.Positions(ids, Eigen::all) + share * steps(pending, Eigen::all);
      const Eigen::MatrixXd values = map.Evaluate(positions, progress.Next());
      const Eigen::VectorXd misses = Misses(values, search.Targets(ids, Eigen::all));
      for (std::size_t i = 0; i < ids.size(); ++i)
      {
        const int id = ids[i];
        const double before = search.Misses(id);
        if (misses(i) < (1.0 - 1e-4 * share) * before)
        {
          search.Positions.row(id) = positions.row(i);
          search.Values.row(id) = values.row(i);
          search.Misses(id) = misses(i);
          // If a step from an accepted position gains little, the rest is rounding error.
          if (misses(i) > limits.Goal || (misses(i) > 0.0 && misses(i) < 0.1 * before))
          {
            next.push_back(id);
          }
        }
        else if (before > limits.Goal)
        {
          farther.push_back(pending[i]);
        }
      }
      pending = std::move(farther);
    }
    active = std::move(next);
  }
}

Search WalkToTargets(const SearchedMap& map, const Eigen::MatrixXd& starts,
  const Eigen::MatrixXd& targets, const Limits& limits, Steps& progress)
{
  // A walk that fails even with this step has run into a fold.
  constexpr double shortest = 1.0 / 1024.0;
  constexpr int maximumRounds = 256;
  Search search = StartSearch(map, starts, targets, progress.Next());
  const Eigen::MatrixXd images = search.Values;
  const Eigen::Index n = targets.rows();
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(n), steps = Eigen::VectorXd::Constant(n, 0.25);
  Indices active;
  for (int i = 0; i < n; ++i)
  {
    if (std::isfinite(search.Misses(i)))
    {
      active.push_back(i);
    }
  }
  for (int round = 0; round < maximumRounds && !active.empty(); ++round)
  {
    const Eigen::VectorXd tried = (shares(active) + steps(active)).cwiseMin(1.0);
    const Eigen::MatrixXd from = images(active, Eigen::all);
    const Eigen::MatrixXd to = targets(active, Eigen::all);
    Search part = StartSearch(map, search.Positions(active, Eigen::all),
      from + tried.asDiagonal() * (to - from), progress.Next());
    // A few iterations suffice for a short step of the walk. If they do not, the step is halved.
    IterateNewton(map, part, { limits.Goal, limits.MaxStep, 8 }, progress);
    Indices next;
    for (std::size_t i = 0; i < active.size(); ++i)
    {
      const int id = active[i];
      const bool reached = part.Misses(i) <= limits.Goal;
      if (reached)
      {
        search.Positions.row(id) = part.Positions.row(i);
        shares(id) = tried(i);
      }
      steps(id) *= reached ? 2.0 : 0.5;
      if (shares(id) < 1.0 && steps(id) >= shortest)
      {
        next.push_back(id);
      }
    }
    active = std::move(next);
  }
  // The walk ends near the target, or where it got stuck. Newton's method continues from there to
  // the target itself.
  search = StartSearch(map, search.Positions, targets, progress.Next());
  IterateNewton(map, search, limits, progress);
  return search;
}

} // namespace shape
