#include "Correspondence/Pair/MatchingInput.h"

#include "Base/Errors.h"
#include "Mesh/Surface.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shape
{

void RequireArea(const Surface& surface, const std::string& name)
{
  const double area = ComputePointAreas(surface).sum();
  // All methods divide by the root of the area.
  if (!(area > 0.0 && std::isfinite(area)))
  {
    std::ostringstream longest;
    longest << ComputeLongestBoxEdge(surface.Points());
    throw InvalidInput(name +
      " has no area that double precision can represent (the longest edge of its box is " +
      longest.str() + "); scale it or check its coordinates");
  }
}

Topology RequireWhole(const Surface& surface, const std::string& name)
{
  Topology topology = RequireManifold(surface, name);
  const auto unused = (topology.ComponentId.array() < 0).count();
  if (unused > 0)
  {
    const auto first = std::find(topology.ComponentId.begin(), topology.ComponentId.end(), -1) -
      topology.ComponentId.begin();
    throw InvalidInput(name + " has " + std::to_string(unused) +
      " points that no triangle uses (first at point " + std::to_string(first) +
      "); remove them with Clean");
  }
  RequireArea(surface, name);
  return topology;
}

Topology RequireConnected(const Surface& surface, const std::string& name)
{
  Topology topology = RequireWhole(surface, name);
  if (topology.Components > 1)
  {
    throw InvalidInput(name + " has " + std::to_string(topology.Components) +
      " components, and distances between components are undefined; keep one with Connectivity / "
      "Extract Largest");
  }
  return topology;
}

int ComputeGenus(const Topology& topology)
{
  // From the Euler number V - E + F = 2 components - 2 genus - loops.
  return (2 * topology.Components - topology.EulerNumber - topology.BoundaryLoops) / 2;
}

void RequireLandmarks(const Landmarks& landmarks, const Surface& a, const Surface& b)
{
  for (std::size_t k = 0; k < landmarks.size(); ++k)
  {
    for (const int which : { 0, 1 })
    {
      const auto points = static_cast<int>((which == 0 ? a : b).Points().rows());
      const int point = landmarks[k][which];
      if (point < 0 || point >= points)
      {
        throw InvalidInput("landmark " + std::to_string(k) + " is point " + std::to_string(point) +
          " of surface " + (which == 0 ? "A" : "B") + ", which has " + std::to_string(points) +
          " points; number points from 0");
      }
    }
  }
}

std::vector<int> PointsOf(const Landmarks& landmarks, int which)
{
  std::vector<int> points;
  for (const auto& landmark : landmarks)
  {
    points.push_back(landmark[which]);
  }
  return points;
}

} // namespace shape
