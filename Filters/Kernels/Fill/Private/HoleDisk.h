#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

/**
 * Returns the corners (k x 2, counter-clockwise, from angle 0 on) of the polygon that has the given
 * edge lengths and is inscribed in a circle. Edge i starts at corner i. "The boundary loop is
 * embedded in a 2D circle, such that the distances between vertices are preserved" (Schmidt and
 * Singh, "Drag-and-drop surface composition", section 4.1). The circle's centre is outside the
 * polygon if one edge is longer than half of the circle.
 *
 * lengths: k values (k >= 3), each >= 0, not all 0. Lengths below a thousandth of their mean are
 * raised to that value, so that no two corners coincide. A length that is not less than the sum of
 * the others is shortened.
 */
Eigen::MatrixXd BuildCircleOutline(const Eigen::VectorXd& lengths);

/// A flat disk.
struct FlatDisk
{
  Eigen::MatrixXd Points;    ///< n x 2: the outline's corners first, in order
  Eigen::MatrixXi Triangles; ///< counter-clockwise
};

struct FlatDiskOptions
{
  /// If `Size` is equal to Edge everywhere, the points form a triangular grid with this edge
  /// length; > 0.
  double Edge = 0.0;
  double Growth = 0.5; ///< the maximum slope of `Size`
  /// The wanted edge length at a position, between Edge / 1000 and 1e6 Edge.
  std::function<double(const Eigen::RowVector2d&)> Size;
  /// Takes two corners of the outline, and returns whether no inner edge may join them; may be
  /// empty. Inner edges between such corners are split at their midpoints.
  std::function<bool(int, int)> IsTaken;
  /// Returns whether an inner edge between two corners would be outside the filled region
  /// (FindOuterChords); may be empty. If the corners are two apart on the outline, the edge is
  /// flipped; otherwise it is split at its midpoint.
  std::function<bool(int, int)> IsOutside;
};

/**
 * Triangulates the inside of a polygon by the constrained Delaunay triangulation of the points of a
 * triangular grid. Cells of the grid are split in four if they are larger than wanted, and points
 * too close to the outline are omitted. Every side of the outline is an edge, and no other points
 * than its corners lie on the outline.
 *
 * outline: k x 2, counter-clockwise. There are no triangles if the outline intersects itself or is
 * collinear. Throws Aborted.
 */
FlatDisk TriangulateDisk(
  const Eigen::MatrixXd& outline, const FlatDiskOptions& options, const Progress& progress = {});

/**
 * Flips the edges for which isOutside is true, if exactly one corner of a disk's outline is between
 * their end points. The new edge starts at that corner.
 *
 * corners: number of corners of the outline, which are the disk's first points. isOutside, isTaken:
 * as in FlatDiskOptions. Edges for which isTaken is true are not created.
 */
void FlipTips(FlatDisk& disk, int corners, const std::function<bool(int, int)>& isOutside,
  const std::function<bool(int, int)>& isTaken);

} // namespace shape
