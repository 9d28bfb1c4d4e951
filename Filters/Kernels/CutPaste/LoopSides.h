#pragma once

#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// The side of its loops on which a feature lies.
enum class LoopSide
{
  Smaller, ///< the one with less area
  Larger,
  Left, ///< of the loop in the order of its points, seen from outside; of the longest of several
  Right
};

/**
 * Marks the triangles (m, 0 or 1) on one side of loops along the edges of a surface: two triangles
 * at an edge of a loop are on different sides, two at any other edge on the same side. So nested
 * loops bound rings, and two loops around a tube bound the part between. The loops divide each
 * component that has some; other components are on neither side.
 *
 * loops: closed, the longest first. The surface may be non-manifold elsewhere. Throws InvalidInput
 * if loops do not divide their component, as one around a handle does not, or if all run along its
 * boundary.
 */
std::vector<char> MarkTrianglesOnSide(
  const Surface& surface, const std::vector<std::vector<int>>& loops, LoopSide side);

} // namespace shape
