#pragma once

#include "Search/RowFinder.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

/// Finds the points of the pieces and blocks of an input in the complete shape that was gathered
/// from them. Coincident points move as one, so any point with the same values is right. Exact
/// values are sufficient, because the shape was gathered without arithmetic.
class vtkShapeWholeRows
{
public:
  /// whole: n x d, the positions of the complete shape, and further values that its points must
  /// have in common; it must exist as long as this object.
  explicit vtkShapeWholeRows(const Eigen::MatrixXd& whole);

  /// Returns the rows of the complete shape for the points of a piece (m x d). Throws
  /// shape::InvalidInput if a point is not in the complete shape.
  std::vector<int> Find(const Eigen::MatrixXd& piece);

private:
  const Eigen::MatrixXd& Whole;
  std::optional<shape::RowFinder> Finder; ///< a single piece needs none
};
