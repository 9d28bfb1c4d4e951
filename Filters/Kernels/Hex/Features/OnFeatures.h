#pragma once

#include "Search/ClosestPoint.h"
#include "Hex/Features/PatchedBoundary.h"
#include "Remesh/SurfaceFeatures.h"
#include "Untangle/SimplexPatch.h"

#include <vector>

namespace shape
{

/// Points of a boundary keep to the corner, the curve or the patch of a surface that they lie on;
/// the others are free.
class OnFeatures : public PointConstraint
{
public:
  /// points: how many the hexahedra have.
  OnFeatures(const Mesh& surface, const SurfaceFeatures& features, const PatchedBoundary& boundary,
    Eigen::Index points);

  int Freedom(int point) const override;
  PointDirections Directions(int point, const Eigen::RowVector3d& place) const override;
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& place) const override;

private:
  /// Of a point on a patch, from the triangle that was found for it before.
  ClosestPlace FindOnPatch(int point, const Eigen::RowVector3d& place) const;

  static constexpr int Free = -1;
  std::vector<int> PlaceOf;             ///< of each point an index into Places or Spans, or Free
  std::vector<int> FreedomOf;           ///< 0 at a corner, 1 on a curve, 2 on a patch, 3
  std::vector<SurfaceLocator> Places;   ///< patches
  std::vector<Eigen::MatrixXd> Spans;   ///< of points on curves and corners: polylines
  std::vector<Eigen::MatrixXd> Normals; ///< of the patches' triangles
  mutable std::vector<int> Guesses;     ///< of each point the triangle found last, or -1
};

} // namespace shape
