#include "Surface/SideFrames.h"

#include "Core/HalfEdges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shape
{

SideFrames::SideFrames(const Mesh& mesh)
  : Begins(mesh.Triangles.size())
  , Twins(mesh.Triangles.size(), -1)
  , Lengths(mesh.Triangles.size())
  , Opposites(mesh.Triangles.size())
  , Angles(mesh.Points.rows(), 0.0)
  , OnBorder(mesh.Points.rows(), 0)
  , From(mesh.Points.rows())
{
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = Corners(mesh, t);
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
  const std::vector<HalfEdge> edges = SortedHalfEdges(mesh.Triangles, mesh.Points.rows());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const int side = 3 * edges[i].Triangle + edges[i].Corner;
    if (i + 1 < edges.size() && edges[i].Low() == edges[i + 1].Low() &&
      edges[i].High() == edges[i + 1].High())
    {
      const int twin = 3 * edges[i + 1].Triangle + edges[i + 1].Corner;
      this->Twins[side] = twin;
      this->Twins[twin] = side;
    }
    else if (this->Twins[side] < 0)
    {
      this->OnBorder[edges[i].Begin] = this->OnBorder[edges[i].End] = 1;
    }
  }
}

} // namespace shape
