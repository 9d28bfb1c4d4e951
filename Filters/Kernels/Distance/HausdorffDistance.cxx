#include "Distance/HausdorffDistance.h"

#include <utility>
#include <vector>

namespace shape
{

PlacesAndDistances DistancesBetween(
  const Mesh& from, const SurfaceLocator& to, int random, const Progress& progress)
{
  std::vector<int> used(from.Triangles.data(), from.Triangles.data() + from.Triangles.size());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  constexpr unsigned int seed = 1;
  PlacesAndDistances result;
  result.Places.resize(static_cast<Eigen::Index>(used.size()) + random, 3);
  result.Places << from.Points(used, Eigen::all), RandomPlaces(from, random, seed);
  ClosestPoints closest = to.Find(result.Places, progress);
  result.Nearest = std::move(closest.Positions);
  result.Distances = std::move(closest.Distances);
  return result;
}

HausdorffDistances HausdorffDistance(
  const Mesh& first, const Mesh& second, const Progress& progress)
{
  return {
    DistancesBetween(first, SurfaceLocator(second), ComparedPlaces, progress.Part(0.0, 0.5))
      .Distances.maxCoeff(),
    DistancesBetween(second, SurfaceLocator(first), ComparedPlaces, progress.Part(0.5, 1.0))
      .Distances.maxCoeff(),
  };
}

} // namespace shape
