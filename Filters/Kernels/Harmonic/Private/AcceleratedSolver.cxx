#include "Harmonic/Private/AcceleratedSolver.h"

#include "Harmonic/NearSurfaceCharges.h"
#include "Harmonic/Private/FundamentalSolutionSolvers.h"
#include "Remesh/LongestEdgeBisection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <vector>

namespace shape
{

namespace
{

/// Iterations go on until each coordinate's error is so much of the tolerance, for all three and
/// positions between the rows to keep it, or until they hardly lower it.
constexpr double ShareOfTolerance = 0.5;

/// Boundaries of fewer points may be refined as far as one of so many: it takes seconds, and
/// those of a few hundred points have the longest triangles.
constexpr double CheapPoints = 2500.0;

/// If the residual of a map is more than this many tolerances, the next solver iterates longer.
constexpr double ToughTolerances = 1.5;

/// A refined boundary with the images of its points.
struct RefinedBoundary
{
  Mesh Surface;
  Eigen::MatrixXd Targets;
};

/// The squares of what is left over, integrated over each triangle by the rule of
/// NearSurfaceChargeSystem.
Eigen::VectorXd SquaresLeft(const Mesh& surface, const Eigen::MatrixXd& left)
{
  const Eigen::VectorXd squares = left.rowwise().squaredNorm();
  const Eigen::VectorXd areas = 0.5 * ComputeAreaVectors(surface).rowwise().norm();
  const Eigen::Index n = surface.Points.rows();
  Eigen::VectorXd sums(surface.Triangles.rows());
  for (Eigen::Index t = 0; t < sums.size(); ++t)
  {
    sums(t) = 0.75 * squares(n + t);
    for (const int corner : surface.Triangles.row(t))
    {
      sums(t) += squares(corner) / 12.0;
    }
    sums(t) *= areas(t);
  }
  return sums;
}

/// Halves the triangles that hold the largest part of what is left over, in the order of Doerfler
/// ("A convergent adaptive algorithm for Poisson's equation", 1996).
void Refine(RefinedBoundary& boundary, const Eigen::MatrixXd& left)
{
  constexpr double share = 0.7;
  const Eigen::VectorXd squares = SquaresLeft(boundary.Surface, left);
  std::vector<int> order(squares.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return squares(a) > squares(b); });
  std::vector<char> marked(order.size(), 0);
  double sum = 0.0;
  for (const int triangle : order)
  {
    if (sum >= share * squares.sum())
    {
      break;
    }
    sum += squares(triangle);
    marked[triangle] = 1;
  }
  const Eigen::MatrixXi ends = BisectLongestEdges(boundary.Surface, marked);
  const Eigen::Index before = boundary.Targets.rows();
  boundary.Targets.conservativeResize(before + ends.rows(), 3);
  for (Eigen::Index k = 0; k < ends.rows(); ++k)
  {
    boundary.Targets.row(before + k) =
      0.5 * (boundary.Targets.row(ends(k, 0)) + boundary.Targets.row(ends(k, 1)));
  }
}

bool AreEqual(const Surface& a, const Surface& b)
{
  return a.Points().rows() == b.Points().rows() && a.Triangles().rows() == b.Triangles().rows() &&
    a.Points() == b.Points() && a.Triangles() == b.Triangles();
}

} // namespace

void SolveAccelerated(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  AcceleratedSetup& setup, HarmonicVolumeMapResult& result, const Progress& progress)
{
  auto start = std::chrono::steady_clock::now();
  const Surface& boundary = problem.Boundary();
  auto effort = NearSurfaceChargeSystem::Effort::Little;
  if (!setup.System || !AreEqual(setup.Boundary, boundary))
  {
    setup.Boundary = boundary;
    setup.System = std::make_unique<NearSurfaceChargeSystem>(
      problem.Distance(), boundary, effort, progress.Part(0.0, 0.3));
  }
  result.OffsetDistance = setup.System->Offset();
  result.PointsWithoutCharge = setup.System->PointsWithoutCharge();
  RefinedBoundary refined{ boundary, problem.Targets() };
  const double maximum =
    options.MostRefined * std::max(CheapPoints, static_cast<double>(boundary.Points().rows()));
  for (int number = 1;; ++number)
  {
    const double done = 0.3 + 0.7 * (1.0 - 1.0 / number);
    const Progress part = progress.Part(done, 0.3 + 0.7 * (1.0 - 1.0 / (number + 1)));
    std::unique_ptr<NearSurfaceChargeSystem> finer;
    if (number > 1)
    {
      finer = std::make_unique<NearSurfaceChargeSystem>(
        problem.Distance(), refined.Surface, effort, part.Part(0.0, 0.3));
    }
    const NearSurfaceChargeSystem& system = finer ? *finer : *setup.System;
    result.OffsetDistance = std::min(result.OffsetDistance, system.Offset());
    Eigen::MatrixXd targets(system.Rows().rows(), 3);
    targets << refined.Targets, AverageAtCorners(refined.Surface.Triangles, refined.Targets);
    const Eigen::MatrixXd left = problem.Left(system.Rows(), targets, part.Part(0.3, 0.4));
    GmresOptions gmres;
    gmres.Tolerance = ShareOfTolerance * options.Tolerance;
    gmres.LeastGain = options.LeastGain;
    const GmresResult fit = system.Solve(left, gmres, part.Part(0.4, 0.9));
    result.Iterations += fit.Iterations;
    result.RefinedPoints =
      static_cast<int>(refined.Surface.Points.rows() - boundary.Points().rows());
    const double gain = problem.Add(system.Sources(), fit.Solution, part.Part(0.9, 1.0));

    AddLevel(problem, system.Sources().rows(), system.Rows().rows(), gain, start, result);
    const HarmonicVolumeMapResult::Level& level = result.Levels.back();
    if (level.RMSEInside <= options.Tolerance)
    {
      result.Reason = HarmonicVolumeMapResult::Stop::Tolerance;
      return;
    }
    if (number == options.MaximumLevels)
    {
      result.Reason = HarmonicVolumeMapResult::Stop::Levels;
      return;
    }
    if (number > 1 && gain < options.LeastGain)
    {
      result.Reason = HarmonicVolumeMapResult::Stop::NoImprovement;
      return;
    }
    effort = level.RMSEInside > ToughTolerances * options.Tolerance
      ? NearSurfaceChargeSystem::Effort::More
      : NearSurfaceChargeSystem::Effort::Little;
    Refine(refined, fit.Left);
    if (static_cast<double>(refined.Surface.Points.rows()) > maximum)
    {
      result.Reason = HarmonicVolumeMapResult::Stop::Refinement;
      return;
    }
  }
}

} // namespace shape
