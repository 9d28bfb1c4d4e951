#include "Correspondence/Landmarks/LandmarkPairs.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <set>
#include <string>

namespace shape
{
namespace
{

/// The maximum distance of landmarks from the surface; a larger one means that the units differ.
constexpr double MaximumDistanceShare = 0.5;

} // namespace

Eigen::VectorXi FindNearestPoints(const Surface& surface, const Eigen::MatrixXd& positions,
  const std::string& name, const Progress& progress)
{
  const ClosestPoints closest = SurfaceLocator(surface).Find(positions, progress);
  const auto isFar =
    closest.Distances.array() > MaximumDistanceShare * ComputeLongestBoxEdge(surface);
  const auto count = isFar.count();
  if (count > 0)
  {
    const auto first = std::find(isFar.begin(), isFar.end(), true) - isFar.begin();
    throw InvalidInput(std::to_string(count) + (count == 1 ? " landmark is" : " landmarks are") +
      " farther from " + name + " than half the longest edge of its bounding box (first landmark " +
      std::to_string(first) + "); put Landmarks on SurfaceA and their TargetPosition on SurfaceB");
  }
  return FindNearestCorners(closest, surface.Triangles());
}

Landmarks PairLandmarks(const Surface& a, const Eigen::MatrixXd& positionsA, const Surface& b,
  const Eigen::MatrixXd& positionsB, const Progress& progress)
{
  RequireFinite(positionsA, "the set of Landmarks");
  RequireFinite(positionsB, "TargetPosition of the Landmarks");
  const Eigen::VectorXi onA = FindNearestPoints(a, positionsA, "SurfaceA", progress.Part(0.0, 0.5)),
                        onB = FindNearestPoints(b, positionsB, "SurfaceB", progress.Part(0.5, 1.0));
  Landmarks pairs;
  std::set<int> ofA, ofB;
  for (Eigen::Index i = 0; i < onA.size(); ++i)
  {
    // Two landmarks at one point would contradict each other or count twice; the first one is kept.
    if (ofA.count(onA(i)) == 0 && ofB.count(onB(i)) == 0)
    {
      ofA.insert(onA(i));
      ofB.insert(onB(i));
      pairs.push_back({ onA(i), onB(i) });
    }
  }
  return pairs;
}

} // namespace shape
