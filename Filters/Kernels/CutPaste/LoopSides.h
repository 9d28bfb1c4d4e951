#pragma once

#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// The side of the loops on which the feature lies.
enum class LoopSide
{
  Smaller, ///< the side with less area
  Larger,
  /// To the left of the loop in the order of its points, seen from outside. If there are several
  /// loops, the longest one decides.
  Left,
  Right ///< to the right; again, the longest loop decides
};

/**
 * Marks the triangles on one side of loops that run along edges of a surface. Returns m values: 1
 * for marked triangles, else 0. Two triangles that share an edge of a loop are on different sides.
 * Two triangles that share any other edge are on the same side. Nested loops therefore bound rings,
 * and two loops around a tube bound the part between them. A component that contains loops is
 * divided by them; other components are on neither side.
 *
 * loops: indices of the points of closed loops, the longest loop first. The surface may be
 * non-manifold away from the loops. Throws InvalidInput if loops do not divide their component, for
 * example one loop around a handle. Also throws InvalidInput if all loops run along the boundary.
 */
std::vector<char> MarkTrianglesOnSide(
  const Surface& surface, const std::vector<std::vector<int>>& loops, LoopSide side);

} // namespace shape
