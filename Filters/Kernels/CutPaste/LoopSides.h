#pragma once

#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// The side of its loops on which a feature is.
enum class LoopSide
{
  Smaller, ///< the side with less area
  Larger,
  /// Of the loop in the order of its points, seen from outside; of several loops, the longest.
  Left,
  Right
};

/**
 * Marks the triangles (m, 0 or 1) on one side of loops along the edges of a surface. Two triangles
 * at an edge of a loop are on different sides, two at any other edge on the same side. Nested loops
 * therefore bound rings, and two loops around a tube bound the part between them. A component that
 * contains loops is divided by them; other components are on neither side.
 *
 * loops: closed, the longest first. The surface may be non-manifold elsewhere. Throws InvalidInput
 * if loops do not divide their component, for example one loop around a handle, or if all loops run
 * along its boundary.
 */
std::vector<char> MarkTrianglesOnSide(
  const Surface& surface, const std::vector<std::vector<int>>& loops, LoopSide side);

} // namespace shape
