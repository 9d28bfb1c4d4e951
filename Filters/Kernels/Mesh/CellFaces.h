#pragma once

#include "Mesh/Cells.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shape
{

/// Returns the number of corners of a cell_kind; 0 for any other kind.
int GetCornerCount(int kind);

/// Returns the faces of a tetrahedron, pyramid, wedge or hexahedron, with three or four corners
/// each, counter-clockwise seen from outside. A wedge's points 0, 1, 2 are counter-clockwise seen
/// from 3, 4, 5. Any other kind has none.
const std::vector<std::vector<int>>& GetFaces(int kind);

/// A face of a solid cell.
struct CellFace
{
  std::array<int, 4> Points; ///< ascending; in a triangle the first is -1
  int Cell;
  int Face; ///< index into GetFaces
};

/// Returns the faces of all solid cells, sorted such that faces with the same points are adjacent.
std::vector<CellFace> SortFaces(const Cells& cells);

/// Whether face i of the sorted faces lies on the boundary: no other face has the same points.
bool IsBoundaryFace(const std::vector<CellFace>& faces, std::size_t i);

} // namespace shape
