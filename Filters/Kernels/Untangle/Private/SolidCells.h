#pragma once

#include "Base/Progress.h"
#include "Base/ReportInterval.h"
#include "Mesh/Cells.h"
#include "Untangle/EllipticEnergy.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace shape
{

/**
 * A solid of tetrahedra, pyramids, wedges and hexahedra. Its points have current positions and,
 * optionally, positions at rest. A cell is represented by its corner tetrahedra (CellSimplices),
 * and it is inverted if one of them is not positive. Boundary points are the points of faces that
 * belong to a single cell.
 */
class SolidCells
{
public:
  /// rest (n x 3, or empty): the positions at rest. If it is empty, regular cells are the rest
  /// shapes. name: the name of the cells in messages. Throws InvalidInput if there is no cell, or
  /// if a cell is of another kind, repeats a point or has an index out of range. Throws Aborted.
  SolidCells(const Cells& cells, const Eigen::MatrixXd& rest, const std::string& name,
    const Progress& progress = {});

  Eigen::MatrixXd Points; ///< n x 3: current positions
  Eigen::MatrixXd Rest;   ///< n x 3, or empty: positions at rest

  int PointCount() const { return static_cast<int>(this->PointCells.size()); }
  int CellCount() const { return static_cast<int>(this->Kinds.size()); }
  const std::vector<int>& CellsOf(int point) const { return this->PointCells[point]; }
  const std::vector<int>& PointsOf(int cell) const { return this->Corners[cell]; }
  /// Returns the points that share a cell with a point, ascending.
  std::vector<int> NeighboursOf(int point) const;
  bool OnBoundary(int point) const { return this->Boundary[point]; }
  const std::vector<std::array<int, 3>>& BoundaryTriangles() const { return this->Surface; }

  /// Lets a closed surface of inner triangles, outward, be the boundary until ForgetInnerBoundary.
  /// The points outside it stay boundary points if they were.
  void SetInnerBoundary(const std::vector<std::array<int, 3>>& triangles);
  void ForgetInnerBoundary();

  /// Whether a cell is a tetrahedron.
  bool HasTetrahedra() const;
  /// Whether all cells are tetrahedra.
  bool HasOnlyTetrahedra() const;

  /// Returns the corner tetrahedra of a cell.
  const std::vector<std::array<int, 4>>& SimplicesOf(int cell);

  /// Returns the factor from the determinant of the edges of a corner tetrahedron to its share of
  /// the cell's volume (CellSimplices).
  double ShareOf(int cell) const;

  /// Whether a corner tetrahedron of a cell is not positive, by exact predicates.
  bool Inverted(int cell);

  /// Returns the edges (columns) of the reference shape for simplex k of a cell. The reference
  /// shape is the rest shape of the simplex, scaled by `size`. A rest shape that is inverted is
  /// reflected. A rest shape is thickened if its least stretch relative to the regular shape is
  /// below 1/20 of its largest.
  Eigen::Matrix3d Reference(int cell, int k, double size);

  /// Whether an edge or a face (two or three points) can be split. It has to exist, have only
  /// tetrahedra around it and not lie on the boundary.
  bool CanSplit(const std::vector<int>& simplex) const;

  /// Inserts a point at the centroid of an edge, a face or a tetrahedron, both in Points and in
  /// Rest. Every tetrahedron that contains the simplex is split into as many parts as the simplex
  /// has points. Returns the new point.
  int Split(const std::vector<int>& simplex);

  /// Keeps the present state, for RestoreState, instead of one kept before. Splits are recorded
  /// from then on, and positions by KeepPositions, so the cost depends on these, and not on the
  /// solid.
  void KeepState();
  /// Keeps the positions of some points, which may then move.
  void KeepPositions(const std::vector<int>& points);
  /// Takes back all splits since KeepState, and puts the points of KeepPositions back.
  void RestoreState();
  /// Ends the record of splits.
  void ForgetState() { this->Kept.reset(); }

  /// Returns the current cells. The first part of a split cell keeps the cell's index, and the
  /// other parts are appended.
  Cells Result() const;

  std::vector<int> OriginalCells; ///< for each cell: the original cell that contains it
  /// For each new point: the points at whose centroid it was inserted, padded to four entries with
  /// -1.
  std::vector<std::array<int, 4>> Parents;
  int OriginalPointCount = 0;

private:
  /// What RestoreState needs. Later entries of a point or cell are newer.
  struct State
  {
    int PointCount, CellCount;
    std::vector<std::pair<int, Eigen::RowVector3d>> Positions;
    std::vector<std::pair<int, std::vector<int>>> Corners, PointCells;
  };

  void KeepCells(const std::vector<int>& cells);
  std::vector<int> CellsAround(const std::vector<int>& simplex) const;
  void MarkBoundary(const Cells& cells, const Progress& progress);
  void TurnWedges();

  std::vector<int> Kinds;
  std::vector<std::vector<int>> Corners;
  std::vector<std::vector<int>> PointCells;
  std::vector<char> Boundary;
  std::vector<std::array<int, 3>> Surface;
  std::vector<std::array<int, 3>> OuterSurface; ///< the boundary while there is an inner one
  std::unordered_set<long long> BoundaryEdges;
  bool WedgesInverted = false;
  std::vector<std::array<int, 4>> Scratch;
  std::optional<State> Kept;
};

} // namespace shape
