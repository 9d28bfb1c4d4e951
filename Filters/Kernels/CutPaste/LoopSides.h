#pragma once

#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// On which side of its loops a feature lies.
enum class LoopSide
{
  Smaller, ///< where there is less area
  Larger,
  Left, ///< of the loop, as its points are in order, seen from outside; of the longest of several
  Right
};

/**
 * The triangles (m, 0 or 1) on one side of loops along the edges of a surface: two triangles beside
 * an edge of a loop are on different sides, two beside any other edge on the same. So loops inside
 * each other bound rings, and two around a tube the part between. Each component that has loops is
 * parted by them; others are on neither side.
 *
 * loops: closed, the longest first. The surface may be non-manifold elsewhere. Throws InvalidInput
 * where loops do not part their component, as one around a handle does not, or run along its border
 * alone.
 */
std::vector<char> MarkTrianglesOnSide(
  const Surface& surface, const std::vector<std::vector<int>>& loops, LoopSide side);

} // namespace shape
