#pragma once

#include "Mesh/Cells.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shape
{

/// Returns the number of corners of a cell_kind; 0 for any other kind.
int GetCornerCount(int kind);

/// Returns the faces of a tetrahedron, pyramid, wedge or hexahedron; none for any other kind. Each
/// face lists its three or four corners counter-clockwise, seen from outside. Corners 0, 1, 2 of a
/// wedge are counter-clockwise seen from corners 3, 4, 5.
const std::vector<std::vector<int>>& GetFaces(int kind);

/// A face of a solid cell.
struct CellFace
{
  std::array<int, 4> Points; ///< ascending; the first is -1 if the face is a triangle
  int Cell;
  int Face; ///< index into GetFaces
};

/// Returns the faces of all solid cells, sorted such that faces with the same points are adjacent.
std::vector<CellFace> SortFaces(const Cells& cells);

/// Whether face i of the sorted faces (SortFaces) is on the boundary: no other face has the same
/// points.
bool IsBoundaryFace(const std::vector<CellFace>& faces, std::size_t i);

} // namespace shape
