#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// A surface while it is mended.
struct MendedDraft
{
  Mesh Surface;
  std::vector<int> Triangles; ///< for each triangle, the triangle of the input that it comes from
  std::vector<int> Points;    ///< for each point, the point of the input that it is a copy of

  /// Removes all triangles but these (ascending).
  void Keep(const std::vector<int>& triangles);
};

/// Removes triangles with collinear corners without opening the surface: the other triangles at the
/// longest edge of such a triangle are split at the corner between the ends of this edge. Every
/// triangle has three different positions. Returns the number of removed triangles.
int SplitAtCollinearCorners(MendedDraft& draft);

/**
 * Keeps only the first of several triangles on the same three points. If their number is even, they
 * may be a wall between two solids that touch, which none of them is needed for. None is kept if
 * the region of such triangles has a border, and at each edge of the border an even number of other
 * triangles. Returns the number of removed triangles.
 */
int RemoveSameTriangles(MendedDraft& draft);

} // namespace shape
