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
 * A solid of tetrahedra, pyramids, wedges and hexahedra in two states: as it is, and at
 * rest. A cell is looked at in its corner tetrahedra (CellSimplices), which are positive in a
 * cell that is not inverted; the points of its boundary are those of faces that one cell has alone.
 */
class SolidCells
{
public:
  /// rest: n x 3, or empty: then each cell should look like the regular one of its kind. `name` is
  /// what errors call the cells. Throws InvalidInput where a cell is of another kind, repeats a
  /// point or has one that is not there, or there is none.
  SolidCells(const Cells& cells, const Eigen::MatrixXd& rest, const std::string& name);

  Eigen::MatrixXd Points; ///< n x 3
  Eigen::MatrixXd Rest;   ///< n x 3, or empty

  int PointCount() const { return static_cast<int>(this->PointCells.size()); }
  int CellCount() const { return static_cast<int>(this->Kinds.size()); }
  const std::vector<int>& CellsOf(int point) const { return this->PointCells[point]; }
  const std::vector<int>& PointsOf(int cell) const { return this->Corners[cell]; }
  bool OnBoundary(int point) const { return this->Boundary[point]; }
  const std::vector<std::array<int, 3>>& BoundaryTriangles() const { return this->Surface; }

  /// The corner tetrahedra of a cell.
  const std::vector<std::array<int, 4>>& SimplicesOf(int cell);

  /// Whether a corner tetrahedron of a cell is not positive, by exact predicates.
  bool Inverted(int cell);

  /// What simplex k of a cell should look like where lengths are `size` times those at rest. A rest
  /// shape that is flatter than 1 in 20 of a regular one, or turned inside out, is mended.
  Eigen::Matrix3d Reference(int cell, int k, double size);

  /// Whether an edge or face (two or three points) is there, has only tetrahedra around it and is
  /// not of the boundary: then it can be split.
  bool CanSplit(const std::vector<int>& simplex) const;

  /// Puts a point into the middle of an edge, a face or a tetrahedron, at rest, too: every
  /// tetrahedron that has it becomes as many as it has points. Returns the new point.
  int Split(const std::vector<int>& simplex);

  /// The cells as they are; those that were split come where they were and at the end.
  Cells Result() const;

  std::vector<int> OriginalCells;          ///< for each cell
  std::vector<std::array<int, 4>> Parents; ///< of each new point; -1 where fewer
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
