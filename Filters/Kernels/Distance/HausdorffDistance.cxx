#include "Distance/HausdorffDistance.h"

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
  positions.OfSurface.resize(static_cast<Eigen::Index>(used.size()) + random, 3);
  positions.OfSurface << surface.Points()(used, Eigen::all), SampleRandomly(surface, random, seed);
  return positions;
}

} // namespace

SampledDistances ComputeDistancesToSurface(
  const Surface& from, const SurfaceLocator& to, const Progress& progress)
{
  SampledDistances result;
  result.Positions =
    from.Cached<ComparedPositions>([&]() { return ChoosePositions(from); })->OfSurface;
  ClosestPoints closest = to.Find(result.Positions, progress);
  result.Nearest = std::move(closest.Positions);
  result.Distances = std::move(closest.Distances);
  return result;
}

HausdorffDistances ComputeHausdorffDistance(
  const Surface& first, const Surface& second, const Progress& progress)
{
  return {
    ComputeDistancesToSurface(first, SurfaceLocator(second), progress.Part(0.0, 0.5))
      .Distances.maxCoeff(),
    ComputeDistancesToSurface(second, SurfaceLocator(first), progress.Part(0.5, 1.0))
      .Distances.maxCoeff(),
  };
}

} // namespace shape
