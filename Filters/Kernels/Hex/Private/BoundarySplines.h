#pragma once

#include "Hex/StructuredBlocks.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace shape
{

/// The splines over the sides of blocks that lie on the boundary of a grid, with common control
/// points on common edges.
struct BoundarySplines
{
  /// points: the number of points of the grid.
  BoundarySplines(
    const std::vector<GridBlock>& blocks, Eigen::Index points, const BlockSplineOptions& options);

  std::vector<int> Points;           ///< the points on these sides, ascending
  Eigen::SparseMatrix<double> Basis; ///< takes control points to points of the grid
  /// Takes control points to second differences along sides, also across their common edges.
  Eigen::SparseMatrix<double> Differences;
};

} // namespace shape
