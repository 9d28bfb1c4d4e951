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
 * Lets points slide along a surface: those inside its smooth parts in two directions, those on its
 * creases (edges whose triangles meet at more than DefaultFeatureAngle) along these, and corners
 * not at all.
 */
class SlidingBoundary : public PointConstraint
{
public:
  /// The surface is that of the triangles, whose points are the ones that slide.
  SlidingBoundary(const Eigen::MatrixXd& points, const std::vector<std::array<int, 3>>& triangles);

  int Freedom(int point) const override;
  PointDirections Directions(int point, const Eigen::RowVector3d& position) const override;
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const override;

private:
  void FindCreases(const std::vector<std::array<int, 3>>& triangles);
  /// The nearest position on the crease and the crease's direction there.
  std::pair<Eigen::RowVector3d, Eigen::RowVector3d> OnCrease(
    int point, const Eigen::RowVector3d& position) const;

  SurfaceLocator Locator;
  Eigen::MatrixXd Normals;                              ///< n x 3, at the surface's points
  std::vector<int> Freedoms;                            ///< of the surface's points, 3 of others
  std::vector<int> CreaseOf;                            ///< -1: none
  std::vector<std::vector<std::array<int, 2>>> Creases; ///< their edges
};

} // namespace shape
