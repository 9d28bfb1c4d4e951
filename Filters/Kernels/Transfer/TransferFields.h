#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"
#include "Search/CellLocator.h"

#include <Eigen/SparseCore>

namespace shape
{

struct TransferFieldsOptions
{
  /// Which of the two shapes carries the map.
  enum class DirectionType
  {
    Pull, ///< the receiver's map f leads into the giver: its point x takes the value at f(x)
    Push  ///< the giver's map h leads into the receiver: its point z hands its value to h(z)
  };
  DirectionType Direction = DirectionType::Pull;
  /// How far beyond the giver's cells a position may lie and still count as one of theirs, as a
  /// share of the longest side of the giver's box: flat cells cut across what is round.
  double Tolerance = 0.01;
};

/// Where the receiver's points (r) take their values from.
struct TransferWeights
{
  /// r x n: interpolates values at the giver's points; rows sum to 1. What lies outside takes the
  /// values of the closest position in a cell.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Weights;
  Eigen::VectorXi Cells;   ///< r: the giver's cell, the closest one outside
  Eigen::VectorXi Outside; ///< r: 1 if farther than the tolerance from every cell, else 0
};

/**
 * Carries values given on one shape to another along a map between them.
 *
 * A value is carried to x as the giver's interpolant at the position that corresponds to x: in its
 * cell that contains the position, by shape functions; on a surface at the closest position,
 * by barycentric weights. Pull composes maps, too: where t is a map given at the giver's points,
 * the interpolated t is t(f(x)). Push looks x up in the image of the giver, its cells with their
 * points at h: the inverse of h, which should not fold the giver.
 */
class TransferFields
{
public:
  /// giver: solid or surface, finite. map: with Push, the map at its points (n x 3), in the
  /// receiver's space; else it may be empty. Throws InvalidInput if the giver has no polygon or
  /// solid cell, or a position or the map is not finite; Aborted.
  explicit TransferFields(Cells giver, const Eigen::MatrixXd& map = {},
    const TransferFieldsOptions& options = {}, const Progress& progress = {});

  /// positions: r x 3, with Pull the receiver's map at its points, with Push these points
  /// themselves. Throws InvalidInput if one is not finite, Aborted.
  TransferWeights Find(const Eigen::MatrixXd& positions, const Progress& progress = {}) const;

private:
  TransferFields(
    const Cells& giver, const TransferFieldsOptions& options, const Progress& progress);

  TransferFieldsOptions::DirectionType Direction;
  double Farthest;
  CellLocator Locator;
};

} // namespace shape
