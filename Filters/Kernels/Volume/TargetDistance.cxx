#include "Volume/TargetDistance.h"

#include "Core/Errors.h"
#include "Core/Topology.h"
#include "Geometry/ClosestPoint.h"

#include <cmath>
#include <string>

namespace shape
{

namespace
{

std::string Described(const Topology& topology)
{
  return "Euler number " + std::to_string(topology.EulerNumber) + " in " +
    std::to_string(topology.Components) + (topology.Components == 1 ? " component" : " components");
}

} // namespace

double TargetDistance(const Mesh& boundary, const Eigen::MatrixXd& targets, const Mesh& target,
  const Progress& progress)
{
  const Topology from = RequireClosedSurface(boundary, "the Boundary");
  const Topology onto = RequireClosedSurface(target, "the Target");
  if (from.EulerNumber != onto.EulerNumber || from.Components != onto.Components)
  {
    throw InvalidInput("the Boundary has " + Described(from) + " and the Target has " +
      Described(onto) +
      ": no map takes one onto the other without a tear; give a Target of the same genus, or "
      "close handles that are noise first");
  }
  const Eigen::VectorXd distances = SurfaceLocator(target).Find(targets, progress).Distances;
  return std::sqrt(distances.squaredNorm() / distances.size()) / LongestSide(target.Points);
}

} // namespace shape
