#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"

#include <Eigen/SparseCore>

#include <memory>

namespace shape
{

/// The location of n positions in cells.
struct CellPoints
{
  Eigen::VectorXi Ids; ///< n: the cell of each position; -1 if all cells are too far
  /// n x number of points of the cells: each row has the weights that interpolate point values to
  /// one position. A row has entries at the corners of the cell, or of one of its triangles, and
  /// sums to 1. It is empty if all cells are too far.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Weights;
  /// n: 0 inside the cell, else the distance to the closest point of the cell; infinite if all
  /// cells are too far
  Eigen::VectorXd Distances;
};

/**
 * Finds the cell that contains a position, and the interpolation weights of the cell's points
 * there. A locator is built once and can be queried from any thread.
 *
 * Solid cells interpolate by their shape functions, as in vtkCell::EvaluatePosition: linear in
 * tetrahedra, trilinear in hexahedra, so linear functions of space are reproduced exactly. For a
 * position outside all cells, the result is the closest point on a face of a cell; faces are split
 * into triangles.
 *
 * If no cell is solid, polygons are split into triangles, and the result is the closest point on
 * them, with barycentric weights. If there are solid cells, polygons are ignored. Lines and
 * vertices are always ignored.
 */
class CellLocator
{
public:
  /// Throws InvalidInput if no cell is a polygon or solid, or if a cell is a polyhedron, which has
  /// no shape functions; Aborted.
  explicit CellLocator(const Cells& cells, const Progress& progress = {});
  ~CellLocator();
  CellLocator(CellLocator&&) noexcept;
  CellLocator& operator=(CellLocator&&) noexcept;

  /// positions: n x 3, finite. Throws InvalidInput if the square of a distance overflows; Aborted.
  CellPoints Find(const Eigen::MatrixXd& positions, const Progress& progress = {}) const;

  /// The same, but cells whose distance is larger than `farthest` are too far to be found. A limit
  /// makes the search faster.
  CellPoints Find(
    const Eigen::MatrixXd& positions, const Progress& progress, double farthest) const;

private:
  struct Search;
  struct SolidSearch;
  struct SurfaceSearch;
  std::unique_ptr<Search> Impl;
};

} // namespace shape
