#include "Hex/OnSurface.h"

#include <Eigen/Geometry>

#include <utility>

namespace shape
{

OnSurface::OnSurface(const SurfaceLocator& locator, std::vector<char> on)
  : Locator(locator)
  , Normals(AreaVectors(locator.Surface()).rowwise().normalized())
  , On(std::move(on))
{
}

PointDirections OnSurface::Directions(int /*point*/, const Eigen::RowVector3d& place) const
{
  const Eigen::Vector3d normal =
    this->Normals.row(this->Locator.Find(place).Triangles(0)).transpose();
  const Eigen::Vector3d one = normal.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> directions;
  directions << one, normal.cross(one);
  return directions;
}

Eigen::RowVector3d OnSurface::Nearest(int /*point*/, const Eigen::RowVector3d& place) const
{
  return this->Locator.Find(place).Positions.row(0);
}

} // namespace shape
