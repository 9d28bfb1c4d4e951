#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Parameterize/ConvexCombination.h"

#include <vector>

namespace shape
{

/// The image of the surface's boundary loop, parameterised by arc length.
enum class DiskOutline
{
  Circle = 0, ///< the unit circle
  Square = 1  ///< the boundary of [-1, 1] x [-1, 1]
};

struct DiskMapOptions
{
  /// MeanValue weights never flip a triangle and still depend on the shape: they reproduce a flat
  /// surface and stay close to Cotangent's angles.
  CombinationWeights Weights = CombinationWeights::MeanValue;
  DiskOutline Outline = DiskOutline::Circle;
};

struct DiskMapResult
{
  Eigen::MatrixXd Points;  ///< n x 3, z = 0: the image of each point
  std::vector<int> Loop;   ///< the boundary loop; its image is counter-clockwise
  double LoopLength = 0.0; ///< length of the loop in the surface's units
  /// flipped triangles of the image: always 0, otherwise the function throws
  int FlippedTriangles = 0;
};

/**
 * Maps a surface with one boundary loop and no handle one-to-one to the disk (or square) in the
 * plane z = 0. The loop is mapped by arc length, every other point to the weighted mean of its
 * neighbours (SolveConvexCombination). Triangles that are counter-clockwise seen from outside are
 * counter-clockwise seen from +z.
 *
 * With Uniform and MeanValue weights no triangle of the exact solution is flipped (Tutte 1963,
 * Floater 2003). The square needs one more condition: an inner edge must not join two points of one
 * side, and such a surface is rejected. Cotangent weights may flip triangles if angles are obtuse.
 * Every triangle of the image is checked with exact orientation predicates, so a result has no
 * flipped triangle.
 *
 * The loop's point with the greatest x (ties: greatest y, then z) is mapped to (1, 0) on the
 * circle, or to the corner (1, 1) of the square. So the map does not depend on the numbering, and a
 * flat disk or square may stay where it is. The other corners are the loop's points closest to
 * quarters of its length from there, in order. Between corners a side is divided by arc length.
 * Translating or scaling the surface changes the result by rounding only.
 *
 * Throws InvalidInput if the surface has no loop or several, several components, handles,
 * non-manifold edges or points, unused points, or a loop edge without length. Throws SolveFailure
 * if the image has flipped triangles, or triangles too small to determine their orientation: on the
 * disk an extremity shrinks exponentially with its length over its girth. The factorisation is one
 * library call that cannot be interrupted. Throws Aborted.
 */
DiskMapResult MapToDisk(
  const Surface& surface, const DiskMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
