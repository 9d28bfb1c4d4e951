#include "Parameterize/OrbifoldInput.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace shape
{
namespace
{

void RequireSphere(const Surface& surface)
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
      " (genus " + std::to_string((2 - topology.EulerNumber) / 2) +
      "); an orbifold needs genus 0: cut each handle with Clip and close the cuts with "
      "Shape Fill Holes");
  }
  const auto unused = (topology.ComponentId.array() < 0).count();
  if (unused > 0)
  {
    throw InvalidInput("the surface has " + std::to_string(unused) +
      (unused == 1 ? " point that no triangle uses" : " points that no triangle uses") +
      "; remove unused points with Clean");
  }
}

void RequireDistinctCones(const Mesh& surface, const std::vector<int>& cones)
{
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    if (cones[i] < 0 || cones[i] >= surface.Points.rows())
    {
      throw InvalidInput("cone " + std::to_string(i) + " is point " + std::to_string(cones[i]) +
        ", but the surface has only " + std::to_string(surface.Points.rows()) +
        " points; give points of the surface");
    }
    const auto own = cones.begin() + static_cast<std::ptrdiff_t>(i);
    const auto same = std::find(cones.begin(), own, cones[i]);
    if (same != own)
    {
      throw InvalidInput("cones " + std::to_string(same - cones.begin()) + " and " +
        std::to_string(i) + " are the same point, " + std::to_string(cones[i]) +
        "; move one of them away from the other");
    }
  }
}

} // namespace

void RequireOrbifoldInput(const Surface& surface, const std::vector<int>& cones)
{
  RequireSphere(surface);
  RequireDistinctCones(surface, cones);
}

void RequireUnflippedTile(const Mesh& cut, const Eigen::MatrixXd& image)
{
  int flipped = 0, first = -1;
  for (int t = 0; t < cut.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = cut.Triangles.row(t);
    if (EvaluateOrientation(image.row(corners(0)), image.row(corners(1)), image.row(corners(2))) <=
      0)
    {
      first = flipped++ == 0 ? t : first;
    }
  }
  if (flipped > 0)
  {
    throw SolveFailure("on the tile, " + std::to_string(flipped) + " of " +
      std::to_string(cut.Triangles.rows()) + " triangles (first triangle " + std::to_string(first) +
      ") are too small for double precision: an extremity shrinks exponentially with the ratio of "
      "its length to its girth; put Landmarks on the ends of the longest extremities");
  }
}

} // namespace shape
