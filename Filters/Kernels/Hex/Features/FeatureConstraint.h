#pragma once

#include "Hex/Features/PatchedBoundary.h"
#include "Remesh/SurfaceFeatures.h"
#include "Search/ClosestPoint.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/Core>

#include <memory>
#include <utility>
#include <vector>

namespace shape
{

/// Keeps each point of a boundary on the corner, curve or patch of the surface that it lies on; all
/// other points are free.
class FeatureConstraint : public PointConstraint
{
public:
  /// points: the number of points of the hexahedra.
  FeatureConstraint(const Surface& surface, const SurfaceFeatures& features,
    const PatchedBoundary& boundary, Eigen::Index points);

  int Freedom(int point) const override;
  PointDirections Directions(int point, const Eigen::RowVector3d& position) const override;
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const override;

private:
  /// Finds the closest point on the patch, starting from the triangle found last for this point.
  ClosestPoint FindOnPatch(int point, const Eigen::RowVector3d& position) const;

  static constexpr int Free = -1;
  std::vector<int> PositionOf; ///< for each point, an index into Positions or Spans, or Free
  std::vector<int> FreedomOf;  ///< 0 at a corner, 1 on a curve, 2 on a patch, 3 otherwise
  std::vector<SurfaceLocator> Positions; ///< one for each patch
  std::vector<Eigen::MatrixXd> Spans;    ///< polylines that points on curves and corners keep to
  std::vector<Eigen::MatrixXd> Normals;  ///< the triangle normals of each patch
  mutable std::vector<int> Guesses;      ///< the triangle found last for each point, or -1
};

/// Another constraint, except that some points can be held or released.
class OverridableConstraint : public PointConstraint
{
public:
  /// Keeps a reference to `others`.
  OverridableConstraint(const PointConstraint& others, Eigen::Index points)
    : Others(others)
  {
    for (int point = 0; point < static_cast<int>(points); ++point)
    {
      this->Freedoms.push_back(static_cast<char>(others.Freedom(point)));
    }
  }

  /// The same, but shares ownership of `others`.
  OverridableConstraint(std::shared_ptr<const PointConstraint> others, Eigen::Index points)
    : OverridableConstraint(*others, points)
  {
    this->Owned = std::move(others);
  }

  int Freedom(int point) const override { return this->Freedoms[point]; }
  PointDirections Directions(int point, const Eigen::RowVector3d& position) const override
  {
    return this->Others.Directions(point, position);
  }
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const override
  {
    return this->Others.Nearest(point, position);
  }

  /// The freedom of each point: initially that of `others`; set to 0 to hold, to 3 to release.
  std::vector<char> Freedoms;

private:
  const PointConstraint& Others;
  std::shared_ptr<const PointConstraint> Owned;
};

} // namespace shape
