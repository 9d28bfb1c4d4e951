#pragma once

#include <array>
#include <vector>

namespace shape
{

/// Triangles, and cells whose corners have three edges each; points in VTK's order.
enum class CellShape
{
  Triangle,
  Tetrahedron,
  Pyramid, ///< its apex has four edges, so only the four corners of its base are used
  Wedge,
  Hexahedron
};

/**
 * Cells divided into the simplices on which a map's Jacobian is evaluated. For surfaces these are
 * triangles. For solids there is one tetrahedron at each corner, with the ends of its three edges;
 * a tetrahedral cell is its own simplex. A cell may have any number of simplices of one dimension:
 * a polygon has the triangles that it is divided into.
 */
struct CellSimplices
{
  /// corners of the simplices; a triangle's last one is -1
  std::vector<std::array<int, 4>> Corners;
  /// Factor by which a simplex's determinant (edges from its first corner) contributes to the
  /// cell's area or volume: exact for triangles and for affine images of the regular cells.
  std::vector<double> Shares;
  std::vector<int> Offsets = { 0 }; ///< first simplex of each cell, and the number of simplices

  /// Adds a shape with `points` (3, 4, 5, 6 or 8 of them) to the current cell.
  void Add(CellShape shape, const int* points);
  /// Ends the current cell. It may have no simplex, as points and lines have.
  void EndCell();
  int Count() const { return static_cast<int>(this->Offsets.size()) - 1; } ///< number of cells
};

} // namespace shape
