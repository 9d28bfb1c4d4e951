#pragma once

#include "Untangle/FoldoverFree.h"

#include <Eigen/Core>

#include <memory>
#include <utility>
#include <vector>

namespace shape
{

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
