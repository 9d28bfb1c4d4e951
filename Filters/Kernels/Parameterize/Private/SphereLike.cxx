#include "Parameterize/Private/SphereLike.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <algorithm>

namespace shape
{

void RequireSphereLike(const Surface& surface, const std::string& map)
{
  const Topology topology = RequireClosedSurface(surface, "the surface");
  if (topology.Components > 1)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.Components) +
      " components; keep one with Connectivity / Extract Largest");
  }
  if (topology.EulerNumber != 2)
  {
    throw InvalidInput("the surface has Euler number " + std::to_string(topology.EulerNumber) +
      " (genus " + std::to_string((2 - topology.EulerNumber) / 2) + "); " + map +
      " needs genus 0: cut each handle with Clip and close the cuts with Shape Fill Holes");
  }
  const auto unused = (topology.ComponentId.array() < 0).count();
  if (unused > 0)
  {
    const auto first = std::find(topology.ComponentId.begin(), topology.ComponentId.end(), -1) -
      topology.ComponentId.begin();
    throw InvalidInput("the surface has " + std::to_string(unused) +
      (unused == 1 ? " point" : " points") + " that no triangle uses (first at point " +
      std::to_string(first) + "); remove unused points with Clean");
  }
}

} // namespace shape
