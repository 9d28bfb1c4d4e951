#pragma once

#include "Mesh/Cells.h"

#include <array>
#include <cstddef>
#include <vector>

namespace shape
{

/// How many corners a kind of cell_kind has; 0 for another kind.
int GetCornerCount(int kind);

/// The faces of a tetrahedron, pyramid, wedge or hexahedron, three or four corners each,
/// counter-clockwise seen from outside (wedges: where 0, 1, 2 are so seen from 3, 4, 5); none for
/// another kind.
const std::vector<std::vector<int>>& GetFaces(int kind);

/// A face of a solid cell.
struct CellFace
{
  std::array<int, 4> Points; ///< in rising order; the first is -1 in triangles
  int Cell;
  int Face; ///< which of GetFaces
};

/// The faces of all solid cells: those with the same points side by side.
std::vector<CellFace> SortFaces(const Cells& cells);

/// Whether no other of the sorted faces has the points of face i: then it is of the boundary.
bool IsBoundaryFace(const std::vector<CellFace>& faces, std::size_t i);

} // namespace shape
