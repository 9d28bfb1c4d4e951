#include "Parameterize/OrbifoldInput.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Parameterize/Private/SphereLike.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace shape
{
namespace
{

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
  RequireSphereLike(surface, "an orbifold");
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
