#include "CutPaste/FeatureFootprint.h"

#include "Base/Errors.h"
#include "Planar/PlanarDelaunay.h"

namespace shape
{

bool IsSimplePolygon(const Eigen::MatrixXd& polygon)
{
  const auto corners = static_cast<int>(polygon.rows());
  Eigen::MatrixXi sides(corners, 2);
  for (int i = 0; i < corners; ++i)
  {
    sides.row(i) << i, (i + 1) % corners;
  }
  try
  {
    // The triangulation is exact: it throws if edges cross, splits an edge at a point on it, and
    // merges coincident points. None of these happens to a simple polygon.
    const PlanarTriangulation flat = TriangulateInPlane(polygon, sides);
    return flat.Edges.rows() == corners &&
      flat.SamePoint == Eigen::VectorXi::LinSpaced(corners, 0, corners - 1);
  }
  catch (const InvalidInput&) // sides cross
  {
    return false;
  }
}

} // namespace shape
