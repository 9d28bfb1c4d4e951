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

/// Points of a boundary keep to the corner, the curve or the patch of a surface that they lie on;
/// the others are free.
class FeatureConstraint : public PointConstraint
{
public:
  /// points: how many the hexahedra have.
  FeatureConstraint(const Surface& surface, const SurfaceFeatures& features,
    const PatchedBoundary& boundary, Eigen::Index points);

  int Freedom(int point) const override;
  PointDirections Directions(int point, const Eigen::RowVector3d& position) const override;
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const override;

private:
  /// Of a point on a patch, from the triangle that was found for it before.
  ClosestPoint FindOnPatch(int point, const Eigen::RowVector3d& position) const;

  static constexpr int Free = -1;
  std::vector<int> PositionOf; ///< of each point an index into Positions or Spans, or Free
  std::vector<int> FreedomOf;  ///< 0 at a corner, 1 on a curve, 2 on a patch, 3
  std::vector<SurfaceLocator> Positions; ///< patches
  std::vector<Eigen::MatrixXd> Spans;    ///< of points on curves and corners: polylines
  std::vector<Eigen::MatrixXd> Normals;  ///< of the patches' triangles
  mutable std::vector<int> Guesses;      ///< of each point the triangle found last, or -1
};

/// Points may go where another constraint lets them, but some are held, or let go.
class OverridableConstraint : public PointConstraint
{
public:
  /// others: is kept.
  OverridableConstraint(const PointConstraint& others, Eigen::Index points)
    : Others(others)
  {
    for (int point = 0; point < static_cast<int>(points); ++point)
    {
      this->Freedoms.push_back(static_cast<char>(others.Freedom(point)));
    }
  }

  /// The same; the others live as long as this.
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

  /// Of each point: the others', until it is made 0 (held) or 3 (let go).
  std::vector<char> Freedoms;

private:
  const PointConstraint& Others;
  std::shared_ptr<const PointConstraint> Owned;
};

} // namespace shape
