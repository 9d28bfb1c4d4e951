#include "Mesh/Extent.h"

#include "Base/Errors.h"

#include <sstream>

namespace shape
{
namespace
{

void RequireExtent(const Eigen::AlignedBox3d& box, const std::string& name)
{
  constexpr double minimum = 1e-50, maximum = 1e50;
  // Three digits of each coordinate are left.
  constexpr double minimumShare = 1e-13;
  const double side = box.sizes().maxCoeff();
  std::ostringstream words;
  if (side != 0.0 && !(side >= minimum && side <= maximum))
  {
    words << name << " has a longest side of " << side << ", and lengths from " << minimum << " to "
          << maximum << " can be computed with; scale it with Transform, or check its coordinates";
    throw InvalidInput(words.str());
  }
  const double farthest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  if (side != 0.0 && side < minimumShare * farthest)
  {
    words << name << " is only " << side << " long at coordinates of " << farthest
          << ", where double precision does not resolve it; move it to the origin before it is "
             "written";
    throw InvalidInput(words.str());
  }
}

} // namespace

Eigen::AlignedBox3d ComputeBox(const Mesh& mesh)
{
  Eigen::AlignedBox3d box;
  if (mesh.Triangles.rows() == 0 && mesh.Points.rows() > 0)
  {
    return { mesh.Points.colwise().minCoeff().transpose(),
      mesh.Points.colwise().maxCoeff().transpose() };
  }
  for (const int point : mesh.Triangles.reshaped())
  {
    box.extend(Eigen::Vector3d(mesh.Points.row(point)));
  }
  return box;
}

double ComputeLongestBoxEdge(const Mesh& mesh)
{
  const Eigen::AlignedBox3d box = ComputeBox(mesh);
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

double ComputeMeanEdgeLength(const Mesh& mesh)
{
  double sum = 0.0;
  for (const auto& corners : mesh.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      sum += (mesh.Points.row(corners(k)) - mesh.Points.row(corners((k + 1) % 3))).norm();
    }
  }
  return sum / static_cast<double>(mesh.Triangles.size());
}

double ComputeBoxDiagonal(const Mesh& mesh)
{
  const Eigen::AlignedBox3d box = ComputeBox(mesh);
  return box.isEmpty() ? 0.0 : box.sizes().norm();
}

void RequireExtent(const Eigen::MatrixXd& points, const std::string& name)
{
  if (points.rows() > 0)
  {
    RequireExtent(Eigen::AlignedBox3d(points.colwise().minCoeff().transpose(),
                    points.colwise().maxCoeff().transpose()),
      name);
  }
}

void RequireExtent(const Mesh& mesh, const std::string& name)
{
  if (mesh.Points.rows() > 0)
  {
    RequireExtent(ComputeBox(mesh), name);
  }
}

} // namespace shape
