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
  double Edge = 0.0;   ///< where `size` is this, the points are a triangular grid of this side; > 0
  double Growth = 0.5; ///< by how much `size` differs, at most, over a distance of 1
  /// The length of edges wanted at a place, within 1/1000 of Edge and 1e6 of it.
  std::function<double(const Eigen::RowVector2d&)> Size;
  /// Whether two corners of the outline must not become an edge inside, or none: an edge that is
  /// there gets a point in its middle.
  std::function<bool(int, int)> IsTaken;
  /// Whether an edge inside between two corners would not be on the side of the outline that is
  /// filled, as FindOuterChords says, or none. Where they are two apart the edge is flipped, else
  /// it gets a point in its middle.
  std::function<bool(int, int)> IsOutside;
};

/**
 * Triangulates the inside of a polygon: points on a triangular grid whose cells are split in four
 * where they are larger than wanted, those too close to the outline left out, and the constrained
 * Delaunay triangulation. Every side of the outline is an edge; its corners are the only points on
 * it.
 *
 * outline: k x 2, counter-clockwise. No triangles where it meets itself, or all of it lies on one
 * line. Throws Aborted.
 */
FlatDisk TriangulateDisk(
  const Eigen::MatrixXd& outline, const FlatDiskOptions& options, const Progress& progress = {});

/**
 * Where a triangle of a disk joins two corners of its outline that are two apart, and they should
 * not be joined, the edge from the corner between them is taken instead.
 *
 * corners: of the outline, the disk's first points. isTaken: which edges must not be made, or none.
 */
void FlipTips(FlatDisk& disk, int corners, const std::function<bool(int, int)>& isOutside,
  const std::function<bool(int, int)>& isTaken);

} // namespace shape
