#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"
#include "Search/CellLocator.h"

#include <Eigen/SparseCore>

namespace shape
{

struct TransferFieldsOptions
{
  /// The shape that carries the map.
  enum class DirectionType
  {
    Pull, ///< the receiver's map f leads into the giver: its point x takes the value at f(x)
    Push  ///< the giver's map h leads into the receiver: its point z gives its value to h(z)
  };
  DirectionType Direction = DirectionType::Pull;
  /// The maximum distance from the giver's cells at which a position belongs to them, relative to
  /// the longest edge of the giver's bounding box: flat cells cut off curved boundaries.
  double Tolerance = 0.01;
};

/// The weights by which the receiver's points (r) take their values from the giver's points (n).
struct TransferWeights
{
  /// r x n: interpolates values at the giver's points; each row sums to 1. A position outside all
  /// cells takes the value at the closest point in a cell.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Weights;
  Eigen::VectorXi Cells;   ///< r: the giver's cell, or the closest one if outside
  Eigen::VectorXi Outside; ///< r: 1 if farther than the tolerance from every cell, else 0
};

/**
 * Transfers values from one shape to another along a map between them.
 *
 * The value at x is the giver's interpolant at the position that corresponds to x. In a solid this
 * is interpolated by the shape functions of the cell that contains the position; on a surface by
 * barycentric weights at the closest point.
 *
 * Pull also composes maps: if t is a map given at the giver's points, the interpolated t is
 * t(f(x)). Push looks x up in the image of the giver, whose points are moved to h. This inverts h,
 * which should not fold the giver.
 */
class TransferFields
{
public:
  /// giver: a solid or a surface with finite coordinates. map: for Push, the map at its points (n x
  /// 3), in the receiver's space; for Pull it may be empty. Throws InvalidInput if the giver has no
  /// polygon or solid cell, or if a position or the map is not finite; Aborted.
  explicit TransferFields(Cells giver, const Eigen::MatrixXd& map = {},
    const TransferFieldsOptions& options = {}, const Progress& progress = {});

  /// Returns the weights at positions (r x 3): for Pull the receiver's map at its points, for Push
  /// the receiver's points. Throws InvalidInput if a position is not finite; Aborted.
  TransferWeights Find(const Eigen::MatrixXd& positions, const Progress& progress = {}) const;

private:
  TransferFields(
    const Cells& giver, const TransferFieldsOptions& options, const Progress& progress);

  TransferFieldsOptions::DirectionType Direction;
  double Farthest;
  CellLocator Locator;
};

} // namespace shape
