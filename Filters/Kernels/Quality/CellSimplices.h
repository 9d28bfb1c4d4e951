#pragma once

#include <array>
#include <vector>

namespace shape
{

/// Triangles, and solid cells whose corners have three edges each. Their points are in VTK's order.
enum class CellShape
{
  Triangle,
  Tetrahedron,
  Pyramid, ///< its apex has four edges, so only the four corners of its base are used
  Wedge,
  Hexahedron
};

/**
 * Cells divided into the simplices on which a map's Jacobian is evaluated. The simplices of surface
 * cells are triangles. A solid cell has one tetrahedron at each corner, formed by the corner and
 * the ends of its three edges; a tetrahedral cell is its own simplex. A cell may have any number of
 * simplices, all of one dimension: a polygon has the triangles that it is divided into.
 */
struct CellSimplices
{
  /// for each simplex, its corners; the last entry of a triangle is -1
  std::vector<std::array<int, 4>> Corners;
  /// A factor for each simplex. Multiplied by the determinant of the edges from the simplex's first
  /// corner, it gives the simplex's share of the cell's area or volume. The share is exact for
  /// triangles and for affine images of the regular cells.
  std::vector<double> Shares;
  /// the first simplex of each cell, then the number of simplices
  std::vector<int> Offsets = { 0 };

  /// Adds a shape to the current cell. points: the 3, 4, 5, 6 or 8 points of the shape.
  void Add(CellShape shape, const int* points);
  /// Ends the current cell. Like points and lines, it may have no simplex.
  void EndCell();
  int Count() const { return static_cast<int>(this->Offsets.size()) - 1; } ///< number of cells
};

} // namespace shape
