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
  /// surface, and the angles of the image are close to those with Cotangent weights.
  CombinationWeights Weights = CombinationWeights::MeanValue;
  DiskOutline Outline = DiskOutline::Circle;
};

struct DiskMapResult
{
  Eigen::MatrixXd Points;  ///< n x 3, z = 0: the image of each point
  std::vector<int> Loop;   ///< the boundary loop; its image is counter-clockwise
  double LoopLength = 0.0; ///< length of the loop in the surface's units
  /// number of flipped triangles in the image: always 0, because MapToDisk throws otherwise
  int FlippedTriangles = 0;
};

/**
 * Maps a surface with one boundary loop and no handle one-to-one to the disk (or square) in the
 * plane z = 0. The loop is mapped by arc length, and every other point to the weighted mean of its
 * neighbours (SolveConvexCombination). Triangles that are counter-clockwise on the surface, seen
 * from outside, are counter-clockwise in the image, seen from +z.
 *
 * With Uniform and MeanValue weights no triangle of the exact solution is flipped (Tutte 1963,
 * Floater 2003). The square needs one more condition: no inner edge may join two points that are
 * mapped to the same side. Cotangent weights may flip triangles if angles are obtuse. Every
 * triangle of the image is checked with exact orientation predicates, so a result has no flipped
 * triangle.
 *
 * The loop's point with the greatest x (ties: greatest y, then z) is mapped to (1, 0) on the
 * circle, or to the corner (1, 1) of the square. So the map does not depend on the order of the
 * points, and can leave a flat disk or square unchanged. The loop's points closest to one, two and
 * three quarters of its length from there are mapped to the other three corners. Between two
 * corners, points are placed by arc length. Translating or scaling the surface changes the result
 * by rounding only.
 *
 * Throws InvalidInput when RequireSurfaceWithBoundary(surface, LoopCount::One) does, or if an edge
 * of the loop has no length. For the square, it also throws if the loop has fewer than four points,
 * or an inner edge joins two points that are mapped to the same side. Throws SolveFailure if the
 * image has flipped triangles, or triangles too small to determine their orientation. An extremity
 * shrinks exponentially with the ratio of its length to its girth. Throws Aborted.
 */
DiskMapResult MapToDisk(
  const Surface& surface, const DiskMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
