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
 * Lets points slide along a surface: points in its smooth parts in two directions, points on its
 * creases (edges whose triangles' normals differ by more than DefaultFeatureAngle) along the
 * crease, and corners not at all.
 */
class SlidingBoundary : public PointConstraint
{
public:
  /// triangles: the surface; its points are the ones that slide.
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
  Eigen::MatrixXd Normals;                              ///< n x 3: normals at the surface's points
  std::vector<int> Freedoms;                            ///< for each point; 3 off the surface
  std::vector<int> CreaseOf;                            ///< the crease of each point, or -1
  std::vector<std::vector<std::array<int, 2>>> Creases; ///< the edges of each crease
};

} // namespace shape
