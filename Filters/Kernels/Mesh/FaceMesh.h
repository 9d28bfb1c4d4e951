#pragma once

#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Solid cells of any shape, given by polygons and the cells on their two sides, as in flow solvers.
 * Each face is there once. Its corners are counter-clockwise seen from outside of its owner.
 */
struct FaceMesh
{
  int CellCount = 0;
  std::vector<int> Offsets = { 0 }; ///< f + 1 offsets into Corners
  std::vector<int> Corners;         ///< indices of points
  std::vector<int> Owners;          ///< f: the cell with the lower index
  std::vector<int> Neighbours;      ///< f: the other cell; -1 on the boundary
  std::vector<char> Turned; ///< for each cell: 1 if it is a wedge numbered the other way round

  int FaceCount() const { return static_cast<int>(this->Owners.size()); }
};

/// The VTK cell type of a polyhedron.
constexpr int PolyhedronKind = 42;

/**
 * Finds the faces of tetrahedra, pyramids, wedges, hexahedra and polyhedra.
 *
 * polyhedra: for each polyhedron, in the order of the cells, its faces: the number of corners of a
 * face, then these corners, and so on. They may face either way. Wedges may be numbered in either
 * orientation, because VTK's own sources use both. The faces of tetrahedra, pyramids and hexahedra
 * are taken as they are numbered, so those of an inverted cell face inwards.
 *
 * Throws InvalidInput if there is no cell, a cell is of another kind, a corner is not a point, a
 * face has fewer than three corners, or more than two cells have the same face.
 */
FaceMesh BuildFaceMesh(const Cells& cells, const std::vector<std::vector<int>>& polyhedra = {});

/// Returns the faces of the boundary as triangles (m x 3 indices of points) that face outwards.
/// Each polygon is a fan around its corner with the lowest index.
Eigen::MatrixXi TriangulateBoundary(const FaceMesh& faces);

} // namespace shape
