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

/// Keeps each boundary point of hexahedra on the corner, curve or patch of the surface that the
/// point lies on. All other points are free.
class FeatureConstraint : public PointConstraint
{
public:
  /// points: the number of points of the hexahedra, including inner ones.
  FeatureConstraint(const Surface& surface, const SurfaceFeatures& features,
    const PatchedBoundary& boundary, Eigen::Index points);

  int Freedom(int point) const override;
  PointDirections Directions(int point, const Eigen::RowVector3d& position) const override;
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const override;

private:
  /// Finds the closest position on the point's patch. The search starts from the triangle found
  /// last for this point.
  ClosestPoint FindOnPatch(int point, const Eigen::RowVector3d& position) const;

  static constexpr int Free = -1;
  std::vector<int> PositionOf; ///< for each point, an index into Positions or Spans, or Free
  std::vector<int> FreedomOf;  ///< 0 at a corner, 1 on a curve, 2 on a patch, 3 otherwise
  std::vector<SurfaceLocator> Positions; ///< a locator for each patch
  std::vector<Eigen::MatrixXd> Spans;    ///< for each point on a curve or corner: its polyline
  std::vector<Eigen::MatrixXd> Normals;  ///< the triangle normals of each patch
  mutable std::vector<int> Guesses;      ///< for each point: the triangle found last, or -1
};

/// Acts like another constraint, but single points can be held or released.
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

  /// Like the constructor above, but shares ownership of `others`.
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

  /// The freedom of each point, initially the freedom that `others` gives it. Set it to 0 to hold
  /// the point, or to 3 to release it.
  std::vector<char> Freedoms;

private:
  const PointConstraint& Others;
  std::shared_ptr<const PointConstraint> Owned;
};

} // namespace shape
