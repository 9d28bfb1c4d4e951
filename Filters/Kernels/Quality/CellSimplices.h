#pragma once

#include <array>
#include <vector>

namespace shape
{

/// Cells that have corners with three edges each, and triangles; points in VTK's order.
enum class CellShape
{
  Triangle,
  Tetrahedron,
  Pyramid, ///< its apex has four edges: only the four corners of its base are looked at
  Wedge,
  Hexahedron
};

/**
 * Cells as the simplices on which a map's Jacobian is looked at: triangles of surfaces, and for
 * solids the tetrahedron that each corner makes with the ends of its three edges (a tetrahedron is
 * its own). A cell may have any number of them, of one dimension: a polygon has its triangles.
 */
struct CellSimplices
{
  std::vector<std::array<int, 4>> Corners; ///< a triangle's last one is -1
  /// By which a simplex's determinant (edges from its first corner) is multiplied for its part in
  /// the cell's area or volume: exact for triangles and for affine images of the regular cells.
  std::vector<double> Shares;
  std::vector<int> Offsets = { 0 }; ///< of each cell's first simplex, and the count of all

  /// Adds a shape over `points` (3, 4, 5, 6 or 8 of them) to the cell that is being made.
  void Add(CellShape shape, const int* points);
  /// Ends the cell; it may have no simplex: points and lines.
  void EndCell();
  int Count() const { return static_cast<int>(this->Offsets.size()) - 1; } ///< cells
};

} // namespace shape
