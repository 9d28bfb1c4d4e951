#include "Geodesics/Private/HalfEdgeFrames.h"

#include "Mesh/HalfEdges.h"

#include <Eigen/Geometry>

#include <cmath>

namespace shape
{

HalfEdgeFrames::HalfEdgeFrames(const Mesh& mesh)
  : Begins(mesh.Triangles.size())
  , Twins(FindTwins(mesh.Triangles, mesh.Points.rows()))
  , Lengths(mesh.Triangles.size())
  , Opposites(mesh.Triangles.size())
  , Angles(mesh.Points.rows(), 0.0)
  , OnBoundary(mesh.Points.rows(), 0)
  , From(mesh.Points.rows())
{
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(mesh, t);
    for (int k = 0; k < 3; ++k)
    {
      const int side = static_cast<int>(3 * t + k);
      const Eigen::RowVector3d along = corners.row((k + 1) % 3) - corners.row(k),
                               there = corners.row((k + 2) % 3) - corners.row(k);
      const double length = along.norm();
      this->Begins[side] = mesh.Triangles(t, k);
      this->Lengths[side] = length;
      const double x = length > 0.0 ? along.dot(there) / length : 0.0;
      const double y = length > 0.0 ? along.cross(there).norm() / length : there.norm();
      this->Opposites[side] = { x, y };
      this->Angles[mesh.Triangles(t, k)] += std::atan2(y, x);
      this->From[mesh.Triangles(t, k)].push_back(side);
    }
  }
  for (int side = 0; side < static_cast<int>(this->Twins.size()); ++side)
  {
    if (this->Twins[side] < 0)
    {
      this->OnBoundary[this->Begin(side)] = this->OnBoundary[this->End(side)] = 1;
    }
  }
}

} // namespace shape
