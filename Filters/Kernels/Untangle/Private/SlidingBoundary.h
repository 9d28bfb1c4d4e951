#pragma once

#include "Mesh/Mesh.h"
#include "Search/ClosestPoint.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * Lets the points of a surface slide along it. Points in smooth parts slide in two directions,
 * points on creases slide along the crease, and corners are fixed. An edge is a crease if the
 * normals of its triangles differ by more than DefaultFeatureAngle.
 */
class SlidingBoundary : public PointConstraint
{
public:
  /// triangles: the surface, whose points slide. Other points are free.
  SlidingBoundary(const Eigen::MatrixXd& points, const std::vector<std::array<int, 3>>& triangles);

  int Freedom(int point) const override;
  PointDirections Directions(int point, const Eigen::RowVector3d& position) const override;
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const override;

private:
  void FindCreases(const std::vector<std::array<int, 3>>& triangles);
  /// Returns the nearest position on the point's crease, and the direction of the crease there.
  std::pair<Eigen::RowVector3d, Eigen::RowVector3d> OnCrease(
    int point, const Eigen::RowVector3d& position) const;

  SurfaceLocator Locator;
  Eigen::MatrixXd Normals;   ///< n x 3: the normals at the points of the surface
  std::vector<int> Freedoms; ///< the freedom of each point; 3 off the surface
  std::vector<int> CreaseOf; ///< the crease of each point, or -1
  std::vector<std::vector<std::array<int, 2>>> Creases; ///< the edges of each crease
};

} // namespace shape
