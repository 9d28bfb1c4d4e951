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

/// GMRES stops at this share of the tolerance in each coordinate. The margin covers the sum over
/// three coordinates and the positions between the rows. It also stops when the error hardly
/// decreases.
constexpr double ShareOfTolerance = 0.5;

/// A boundary with fewer points may be refined as much as one with this many. That takes seconds,
/// and boundaries with a few hundred points have the longest triangles.
constexpr double CheapPoints = 2500.0;

/// If the residual of a map exceeds this many tolerances, the next system is set up with more
/// effort.
constexpr double ToughTolerances = 1.5;

/// A refined boundary with the images of its points.
struct RefinedBoundary
{
  Mesh Surface;
  Eigen::MatrixXd Targets;
};

/// Returns the values at this process's points (n x 3 in all), and their means at the centroids of
/// its triangles.
Eigen::MatrixXd TakeOwn(
  const SharedRows& shared, const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values)
{
  const auto &points = shared.OwnRange(0), &own = shared.OwnRange(1);
  Eigen::MatrixXd taken(shared.OwnCount(), 3);
  taken << values.middleRows(points.Begin, points.Size()),
    AverageAtCorners(triangles.middleRows(own.Begin, own.Size()), values);
  return taken;
}

/// Returns the squared residual integrated over each triangle, by the rule of
/// NearSurfaceChargeSystem. left: the residual at this process's rows.
Eigen::VectorXd SquaresLeft(
  const Mesh& surface, const Eigen::MatrixXd& left, const SharedRows& shared)
{
  const Eigen::VectorXd squares = shared.Gather(left.rowwise().squaredNorm());
  const Eigen::Index n = surface.Points.rows();
  const Eigen::VectorXd areas = 0.5 * ComputeAreaVectors(surface).rowwise().norm();
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

/// Bisects the triangles that together hold most of the squared residual (Doerfler marking, "A
/// convergent adaptive algorithm for Poisson's equation", 1996).
void Refine(RefinedBoundary& boundary, const Eigen::MatrixXd& left, const SharedRows& shared)
{
  // The bulk parameter of Doerfler's marking, for squared residuals.
  constexpr double share = 0.7;
  const Eigen::VectorXd squares = SquaresLeft(boundary.Surface, left, shared);
  std::vector<int> order(squares.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return squares(a) > squares(b); });
  std::vector<char> marked(order.size(), 0);
  const double enough = share * squares.sum();
  double sum = 0.0;
  for (const int triangle : order)
  {
    if (sum >= enough)
    {
      break;
    }
    sum += squares(triangle);
    marked[triangle] = 1;
  }
  // A new point is the midpoint of an edge, on which the boundary map is linear: its image is the
  // mean of the ends' images.
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
  // Outline of a level:
  // 1. A system of charges close to the boundary. Later levels use the refined boundary.
  // 2. The residual of the sum so far at the rows of the system.
  // 3. Charges by preconditioned GMRES.
  // 4. The fitted map is scaled and added to the sum.
  // 5. Unless a criterion stops the levels, triangles with the largest residual are bisected.
  auto start = std::chrono::steady_clock::now();
  const Surface& boundary = problem.Boundary();
  const Processes& processes = setup.Processes;
  auto effort = NearSurfaceChargeSystem::Effort::Little;
  const double distance = options.ChargeDistance;
  const SumDevice& device = options.Device;
  if (!setup.System || setup.ChargeDistance != distance || setup.Device != device.Kind ||
    !AreEqual(setup.Boundary, boundary))
  {
    setup.Boundary = boundary;
    setup.ChargeDistance = distance;
    setup.Device = device.Kind;
    setup.System = std::make_unique<NearSurfaceChargeSystem>(
      problem.Distance(), boundary, distance, effort, processes, device, progress.Part(0.0, 0.02));
  }
  result.OffsetDistance = setup.System->Offset();
  result.PointsWithoutCharge = setup.System->PointsWithoutCharge();
  RefinedBoundary refined{ boundary, problem.Targets() };
  const double maximum =
    options.MostRefined * std::max(CheapPoints, static_cast<double>(boundary.Points().rows()));
  for (int number = 1;; ++number)
  {
    // The number of levels is unknown: usually three to five, each of more points than the last.
    const auto end = [](int level)
    {
      constexpr double first[] = { 0.02, 0.08, 0.2 };
      return level < 3 ? first[level] : 1.0 - 0.42 * std::exp2(3 - level);
    };
    const Progress part = progress.Part(end(number - 1), end(number));
    // Step 1: the system.
    std::unique_ptr<NearSurfaceChargeSystem> finer;
    if (number > 1)
    {
      finer = std::make_unique<NearSurfaceChargeSystem>(problem.Distance(), refined.Surface,
        distance, effort, processes, device, part.Part(0.0, 0.55));
    }
    const NearSurfaceChargeSystem& system = finer ? *finer : *setup.System;
    result.OffsetDistance = std::min(result.OffsetDistance, system.Offset());
    // Step 2. The boundary map is linear on triangles: a centroid's image is the mean of the
    // corners' images.
    const Eigen::MatrixXd targets =
      TakeOwn(system.Shares(), refined.Surface.Triangles, refined.Targets);
    const Eigen::MatrixXd left =
      problem.Left(system.Rows(), targets, part.Part(0.55, 0.6, "computing the residual"));
    // Step 3: GMRES.
    GmresOptions gmres;
    gmres.Tolerance = ShareOfTolerance * options.Tolerance;
    gmres.LeastGain = options.LeastGain;
    const GmresResult fit =
      system.Solve(left, gmres, part.Part(0.6, 0.95, "solving for the charges"));
    result.Iterations += fit.Iterations;
    result.RefinedPoints =
      static_cast<int>(refined.Surface.Points.rows() - boundary.Points().rows());
    // Step 4: the sum.
    const Eigen::Index rows = system.Shares().Count();
    const auto [factors, gain] =
      problem.Add(system.Sources(), fit.Solution, part.Part(0.95, 1.0, "measuring the error"));
    AddLevel(problem, system.Sources().rows(), rows, gain, start, result);
    HarmonicVolumeMapResult::Level& level = result.Levels.back();
    // The rows are the collocation points; the scaled map changed the residual there by this much.
    const Eigen::MatrixXd after = left - (left - fit.Left) * factors.asDiagonal();
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(after.rows());
    level.RMSECollocations =
      std::sqrt(system.Shares().Sum(ones, after, after).sum() / static_cast<double>(rows));
    // Step 5: stop or refine.
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
    Refine(refined, fit.Left, system.Shares());
    if (static_cast<double>(refined.Surface.Points.rows()) > maximum)
    {
      result.Reason = HarmonicVolumeMapResult::Stop::Refinement;
      return;
    }
  }
}

} // namespace shape
