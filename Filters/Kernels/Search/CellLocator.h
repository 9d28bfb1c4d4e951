#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"

#include <Eigen/SparseCore>

#include <memory>

namespace shape
{

/// Where n places lie among cells.
struct CellPoints
{
  Eigen::VectorXi Ids; ///< n: the cell
  /// n x points of the cells: what interpolates values given at these to the places. A row has the
  /// corners of its cell, or of a triangle of it, and sums to 1.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Weights;
  Eigen::VectorXd Distances; ///< n: 0 in the cell, else to the closest place in it
};

/**
 * Finds the cell that a place lies in and the weights of its points; built once, queried from any
 * thread.
 *
 * Solid cells interpolate by their shape functions (linear in tetrahedra, trilinear in hexahedra:
 * values that are linear in space are met exactly), as vtkCell::EvaluatePosition gives them.
 * Outside of all of them the closest place on a side of one counts, the side cut into triangles.
 * Where no cell is solid, polygons are cut into triangles, and the closest place on them counts, by
 * barycentric weights. Where there are both, polygons do not count; lines and vertices never do.
 */
class CellLocator
{
public:
  /// Throws InvalidInput where no cell is a polygon or solid, or a cell is a polyhedron, which has
  /// no shape functions; Aborted.
  explicit CellLocator(const Cells& cells, const Progress& progress = {});
  ~CellLocator();
  CellLocator(CellLocator&&) noexcept;
  CellLocator& operator=(CellLocator&&) noexcept;

  /// places: n x 3, finite. Throws InvalidInput where the square of a distance overflows, Aborted.
  CellPoints Find(const Eigen::MatrixXd& positions, const Progress& progress = {}) const;

private:
  struct Search;
  struct SolidSearch;
  struct SurfaceSearch;
  std::unique_ptr<Search> Impl;
};

} // namespace shape
