#pragma once

#include "Mesh/Cells.h"
#include "Untangle/EllipticEnergy.h"

#include <Eigen/Core>

#include <array>
#include <unordered_set>
#include <vector>

namespace shape
{

/**
 * A solid of tetrahedra, pyramids, wedges and hexahedra in two states: the current one, and at
 * rest. A cell is represented by its corner tetrahedra (CellSimplices), all of which are positive
 * if the cell is not inverted. Boundary points are the points of faces that belong to a single
 * cell.
 */
class SolidCells
{
public:
  /// rest: n x 3, or empty, in which case each cell should become similar to the regular one of its
  /// kind. `name` is used for the cells in messages. Throws InvalidInput if there is no cell, or if
  /// a cell is of another kind, repeats a point or has an index out of range.
  SolidCells(const Cells& cells, const Eigen::MatrixXd& rest, const std::string& name);

  Eigen::MatrixXd Points; ///< n x 3
  Eigen::MatrixXd Rest;   ///< n x 3, or empty

  int PointCount() const { return static_cast<int>(this->PointCells.size()); }
  int CellCount() const { return static_cast<int>(this->Kinds.size()); }
  const std::vector<int>& CellsOf(int point) const { return this->PointCells[point]; }
  const std::vector<int>& PointsOf(int cell) const { return this->Corners[cell]; }
  bool OnBoundary(int point) const { return this->Boundary[point]; }
  const std::vector<std::array<int, 3>>& BoundaryTriangles() const { return this->Surface; }

  /// Returns the corner tetrahedra of a cell.
  const std::vector<std::array<int, 4>>& SimplicesOf(int cell);

  /// Whether a corner tetrahedron of a cell is not positive, by exact predicates.
  bool Inverted(int cell);

  /// Returns the reference shape of simplex k of a cell, with lengths `size` times those at rest. A
  /// rest shape that is inverted, or flatter than 1/20 of a regular one, is repaired.
  Eigen::Matrix3d Reference(int cell, int k, double size);

  /// Whether an edge or face (two or three points) can be split: it exists, is surrounded by
  /// tetrahedra only, and does not lie on the boundary.
  bool CanSplit(const std::vector<int>& simplex) const;

  /// Inserts the centroid of an edge, a face or a tetrahedron, at rest as well. Every tetrahedron
  /// that contains the simplex is split into as many parts as the simplex has points. Returns the
  /// new point.
  int Split(const std::vector<int>& simplex);

  /// Returns the current cells. One part of a split cell has its index, the others are appended.
  Cells Result() const;

  std::vector<int> OriginalCells;          ///< for each cell, the original one that contains it
  std::vector<std::array<int, 4>> Parents; ///< of each new point, padded with -1
  int OriginalPointCount = 0;

private:
  std::vector<int> CellsAround(const std::vector<int>& simplex) const;
  void MarkBoundary();
  void TurnWedges();

  std::vector<int> Kinds;
  std::vector<std::vector<int>> Corners;
  std::vector<std::vector<int>> PointCells;
  std::vector<char> Boundary;
  std::vector<std::array<int, 3>> Surface;
  std::unordered_set<long long> BoundaryEdges;
  bool WedgesInverted = false;
  std::vector<std::array<int, 4>> Scratch;
};

} // namespace shape
