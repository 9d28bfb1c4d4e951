#include "CutPaste/FeatureFootprint.h"

#include "Base/Errors.h"
#include "Planar/PlanarDelaunay.h"

#include <Eigen/Geometry>

namespace shape
{

bool operator==(const JoinedLoops& a, const JoinedLoops& b)
{
  return a.Loops == b.Loops && a.LoopIndex == b.LoopIndex;
}

std::vector<int> ConcatenateLoops(const std::vector<std::vector<int>>& loops)
{
  std::vector<int> all;
  for (const std::vector<int>& loop : loops)
  {
    all.insert(all.end(), loop.begin(), loop.end());
  }
  return all;
}

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

Eigen::RowVector3d TurnAxis(const FeatureFootprint& base, const Eigen::RowVector3d& normal)
{
  const Eigen::Vector3d from = base.Normal.transpose(), to = normal.transpose();
  if (from.dot(to) < -1.0 + 1e-12)
  {
    return base.XAxis; // opposite normals: the rotation is about the axis itself
  }
  const Eigen::Vector3d turn = from.cross(to), axis = base.XAxis.transpose();
  // Rodrigues' formula for two unit vectors: the identity, bit for bit, if they are the same.
  return (axis * from.dot(to) + turn.cross(axis) + turn * (turn.dot(axis) / (1.0 + from.dot(to))))
    .transpose();
}

} // namespace shape
