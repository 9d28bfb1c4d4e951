#pragma once

#include "Mesh/HalfEdges.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// Returns the fan of each corner, as an arbitrary number; corner k of triangle t has the index
/// 3 t + k. Two corners at one point are in the same fan if a chain of triangles that share edges
/// at this point connects them. Sheets touch at a point that has several fans. sorted: the
/// half-edges of the mesh (SortHalfEdges).
std::vector<int> FindFans(const Mesh& mesh, const std::vector<HalfEdge>& sorted);

/// A mesh with one fan of triangles at each point.
struct SplitSheets
{
  Mesh Surface; ///< the points of the given mesh, then the copies; the triangles in the same order
  std::vector<int> Copied; ///< for each point, the point of the given mesh at the same position
};

/// Splits each point where sheets touch: the first fan keeps the point, and each further fan gets a
/// copy of it. No position changes, and edges with three or more triangles remain. The indices of
/// the triangles must be in range.
SplitSheets SplitTouchingSheets(const Mesh& mesh);

} // namespace shape
