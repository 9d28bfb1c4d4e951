#pragma once

#include "Geometry/ClosestPoint.h"
#include "Volume/SimplexPatch.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Some points lie on a surface and slide along it; the others are free.
class OnSurface : public PointConstraint
{
public:
  /// on: for each point, whether it lies on the surface. The locator must outlive this.
  OnSurface(const SurfaceLocator& locator, std::vector<char> on);

  int Freedom(int point) const override { return this->On[point] ? 2 : 3; }
  /// Those of the triangle where the surface is closest to the place.
  PointDirections Directions(int point, const Eigen::RowVector3d& place) const override;
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& place) const override;

private:
  const SurfaceLocator& Locator;
  Eigen::MatrixXd Normals; ///< of the triangles
  std::vector<char> On;
};

} // namespace shape
