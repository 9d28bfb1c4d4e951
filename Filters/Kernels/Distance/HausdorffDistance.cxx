#include "Distance/HausdorffDistance.h"

#include <utility>
#include <vector>

namespace shape
{

SampledDistances ComputeDistancesToSurface(
  const Mesh& from, const SurfaceLocator& to, int random, const Progress& progress)
{
  std::vector<int> used(from.Triangles.data(), from.Triangles.data() + from.Triangles.size());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  constexpr unsigned int seed = 1;
  SampledDistances result;
  result.Positions.resize(static_cast<Eigen::Index>(used.size()) + random, 3);
  result.Positions << from.Points(used, Eigen::all), SampleRandomly(from, random, seed);
  ClosestPoints closest = to.Find(result.Positions, progress);
  result.Nearest = std::move(closest.Positions);
  result.Distances = std::move(closest.Distances);
  return result;
}

HausdorffDistances ComputeHausdorffDistance(
  const Surface& first, const Surface& second, const Progress& progress)
{
  return {
    ComputeDistancesToSurface(
      first, SurfaceLocator(second), ComparedPositions, progress.Part(0.0, 0.5))
      .Distances.maxCoeff(),
    ComputeDistancesToSurface(
      second, SurfaceLocator(first), ComparedPositions, progress.Part(0.5, 1.0))
      .Distances.maxCoeff(),
  };
}

} // namespace shape
