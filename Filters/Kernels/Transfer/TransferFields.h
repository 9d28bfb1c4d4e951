#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"
#include "Search/CellLocator.h"

#include <Eigen/SparseCore>

namespace shape
{

struct TransferFieldsOptions
{
  /// The shape on which the map is given.
  enum class DirectionType
  {
    Pull, ///< the receiver has a map f to the giver: its point x takes the value at f(x)
    Push  ///< the giver has a map h to the receiver: its point z gives its value to h(z)
  };
  DirectionType Direction = DirectionType::Pull;
  /// A position farther than this from all cells of the giver is outside; >= 0, relative to the
  /// longest edge of the giver's bounding box. The default is not 0 because flat cells cut off
  /// curved boundaries.
  double Tolerance = 0.01;
};

/// The weights that interpolate values at the giver's n points to the receiver's r points.
struct TransferWeights
{
  /// r x n; each row sums to 1. A position outside all cells takes the value at the closest point
  /// of a cell.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Weights;
  Eigen::VectorXi Cells;   ///< r values: the giver's cell at the position, or the closest cell
  Eigen::VectorXi Outside; ///< r values: 1 if every cell is farther than the tolerance, else 0
};

/**
 * Transfers values from one shape to another along a map between them.
 *
 * The value at x is interpolated at the position in the giver that corresponds to x. In a solid,
 * the weights are the shape functions of the cell that contains the position. On a surface, they
 * are the barycentric coordinates of the closest point.
 *
 * Pull can also compose maps: if a map t is given at the giver's points, the interpolated value is
 * t(f(x)). Push moves each point z of the giver to h(z) and locates x in the moved giver. This
 * inverts h, so h should not fold the giver.
 */
class TransferFields
{
public:
  /// giver: a solid or a surface with finite coordinates. map: for Push, the images of the giver's
  /// points (n x 3), in the receiver's space; not used for Pull. Throws InvalidInput if the giver
  /// has no polygon or solid cell, if Tolerance is negative, or if a point or its image is not
  /// finite; Aborted.
  explicit TransferFields(Cells giver, const Eigen::MatrixXd& map = {},
    const TransferFieldsOptions& options = {}, const Progress& progress = {});

  /// Returns the weights at positions (r x 3). For Pull, these are the images of the receiver's
  /// points; for Push, the receiver's points. Throws InvalidInput if a position is not finite;
  /// Aborted.
  TransferWeights Find(const Eigen::MatrixXd& positions, const Progress& progress = {}) const;

private:
  TransferFields(
    const Cells& giver, const TransferFieldsOptions& options, const Progress& progress);

  TransferFieldsOptions::DirectionType Direction;
  double Farthest;
  CellLocator Locator;
};

} // namespace shape
