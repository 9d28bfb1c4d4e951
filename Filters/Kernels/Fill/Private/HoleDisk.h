#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

/**
 * The corners (k x 2, counter-clockwise, from angle 0 on) of the polygon inscribed in a circle
 * whose sides have these lengths, side i from corner i on: "the boundary loop is embedded in a 2D
 * circle, such that the distances between vertices are preserved" (Schmidt and Singh,
 * "Drag-and-drop surface composition", section 4.1). Its centre is outside where one side is longer
 * than half of the circle.
 *
 * lengths: k >= 3, >= 0, not all 0. Those below a thousandth of their mean are raised to that, so
 * that no two corners coincide; one as long as the others together is shortened.
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
  double Edge =
    0.0; ///< if `Size` is this, the points are a triangular grid of this edge length; > 0
  double Growth = 0.5; ///< the maximum slope of `Size`
  /// The wanted edge length at a position, between Edge / 1000 and 1e6 Edge.
  std::function<double(const Eigen::RowVector2d&)> Size;
  /// Whether two corners of the outline must not be joined by an edge inside; may be empty. Such an
  /// edge gets a point at its midpoint.
  std::function<bool(int, int)> IsTaken;
  /// Whether an edge inside between two corners would be outside of what is filled
  /// (FindOuterChords); may be empty. If they are two apart, the edge is flipped; else it gets a
  /// point at its midpoint.
  std::function<bool(int, int)> IsOutside;
};

/**
 * Triangulates the inside of a polygon by the constrained Delaunay triangulation of the points of a
 * triangular grid, whose cells are split in four if they are larger than wanted, without points too
 * close to the outline. Every side of the outline is an edge; its corners are the only points on
 * it.
 *
 * outline: k x 2, counter-clockwise. There are no triangles if it intersects itself or lies on one
 * line. Throws Aborted.
 */
FlatDisk TriangulateDisk(
  const Eigen::MatrixXd& outline, const FlatDiskOptions& options, const Progress& progress = {});

/**
 * Flips edges between two corners of a disk's outline that are two apart and must not be joined:
 * the edge from the corner between them replaces such an edge.
 *
 * corners: of the outline, the disk's first points. isTaken: which edges must not be made, or none.
 */
void FlipTips(FlatDisk& disk, int corners, const std::function<bool(int, int)>& isOutside,
  const std::function<bool(int, int)>& isTaken);

} // namespace shape
