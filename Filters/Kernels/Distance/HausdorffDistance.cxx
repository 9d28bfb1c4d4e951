#include "Distance/HausdorffDistance.h"

#include "Geometry/Sampling.h"
#include "Mesh/UsedPoints.h"

#include <utility>
#include <vector>

namespace shape
{

namespace
{

/// The positions at which a surface is compared with others.
struct ComparedPositions
{
  Eigen::MatrixXd OfSurface; ///< k x 3
};

/// The points of the surface, where a distance often has its maximum, and random positions between
/// them.
ComparedPositions ChoosePositions(const Surface& surface)
{
  // A fixed seed: the same surfaces have the same distance in every run.
  constexpr int random = 50000;
  constexpr unsigned int seed = 1;
  const Eigen::MatrixXi& triangles = surface.Triangles();
  const std::vector<int> used = FindUsedPoints(triangles, surface.Points().rows());
  ComparedPositions positions;
  const Eigen::MatrixXd between = SampleRandomly(surface, random, seed);
  positions.OfSurface.resize(static_cast<Eigen::Index>(used.size()) + random, 3);
  positions.OfSurface << surface.Points()(used, Eigen::all),
    between(FindSpatialOrder(between), Eigen::all);
  return positions;
}

const Eigen::MatrixXd& GetComparedPositions(const Surface& surface)
{
  return surface.Cached<ComparedPositions>([&]() { return ChoosePositions(surface); })->OfSurface;
}

} // namespace

SampledDistances ComputeDistancesToSurface(
  const Surface& from, const SurfaceLocator& to, const Progress& progress, double enough)
{
  SampledDistances result;
  result.Positions = GetComparedPositions(from);
  ClosestPoints closest = to.Find(result.Positions, progress, enough);
  result.Nearest = std::move(closest.Positions);
  result.Distances = std::move(closest.Distances);
  return result;
}

double ComputeLargestDistanceToSurface(
  const Surface& from, const SurfaceLocator& to, const Progress& progress)
{
  return to.FindLargestDistance(GetComparedPositions(from), progress);
}

HausdorffDistances ComputeHausdorffDistance(
  const Surface& first, const Surface& second, const Progress& progress)
{
  return {
    ComputeLargestDistanceToSurface(first, SurfaceLocator(second), progress.Part(0.0, 0.5)),
    ComputeLargestDistanceToSurface(second, SurfaceLocator(first), progress.Part(0.5, 1.0)),
  };
}

} // namespace shape
