#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Parameterize/ConvexCombination.h"

#include <vector>

namespace shape
{

/// What the surface's boundary loop becomes, by arc length.
enum class DiskOutline
{
  Circle = 0, ///< the unit circle
  Square = 1  ///< the sides of [-1, 1] x [-1, 1]
};

struct DiskMapOptions
{
  /// MeanValue: the only weights that never flip a triangle and still see the shape: they reproduce
  /// a flat surface and stay close to Cotangent's angles.
  CombinationWeights Weights = CombinationWeights::MeanValue;
  DiskOutline Outline = DiskOutline::Circle;
};

struct DiskMapResult
{
  Eigen::MatrixXd Points; ///< n x 3, z = 0: the image of each point
  std::vector<int> Loop; ///< the boundary loop, in the image counter-clockwise from its first point
  double LoopLength = 0.0;  ///< in the surface's units
  int FlippedTriangles = 0; ///< of the image: 0, else it throws
};

/**
 * Maps a surface with one boundary loop and no handle one to one to the disk (or the square) in the
 * plane z = 0: the loop by arc length, every other point to the weighted mean of its neighbours
 * (SolveConvexCombination). Triangles that are counter-clockwise seen from outside are so seen from
 * +z.
 *
 * With Uniform and MeanValue weights no triangle of the exact solution is flipped (Tutte 1963,
 * Floater 2003): on the circle always, on the square unless an inner edge joins two points of one
 * side, which is refused. Cotangent's may flip if angles are obtuse. The image is checked
 * triangle by triangle with exact orientations, so a result has no flipped triangle.
 *
 * The loop's point with the greatest x (of several, the greatest y, then z) goes to (1, 0) on the
 * circle, to the corner (1, 1) of the square: the map depends on no numbering, and a flat disk or
 * square may stay where it is. The square's other corners are the loop's points closest to the
 * quarters of its length from there, each after the one before; between them a side is divided by
 * arc length. Translation and scale of the surface change the result by rounding only.
 *
 * Throws InvalidInput if the surface has no loop, several, components, handles, edges or points
 * that are not manifold, points that no triangle uses, or a loop with an edge without length;
 * SolveFailure if the image has flipped triangles, or such as are too small to tell: on the disk
 * an extremity shrinks exponentially with its length over its girth. The factorisation is one
 * library call that cannot be interrupted. Throws Aborted.
 */
DiskMapResult MapToDisk(
  const Surface& surface, const DiskMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
