#pragma once

#include "Mesh/Cells.h"
#include "Mesh/Mesh.h"

#include <string>

// The Laplace equation by finite elements: the usual method without ShapeMap.
namespace benchmark
{

struct FiniteElementOptions
{
  /// The wanted ratio of the solid's volume / (6 n), for n surface points, to the volume of the
  /// mean tetrahedron; it determines the bound on tetrahedra's volumes. 0: no bound.
  double Refine = 0.0;
  double RadiusEdgeRatio = 2.0; ///< TetGen's default
  /// CHOLMOD (supernodal, OpenBLAS), LLT or LDLT (Eigen's simplicial ones), or CG (Eigen's
  /// conjugate gradients with incomplete Cholesky, to 1e-8).
  std::string Solver = "CHOLMOD";
  /// ordering of CHOLMOD: AMD, METIS or Best (of both)
  std::string Ordering = "AMD"; ///< of CHOLMOD: AMD, METIS or Best (of both)
};

struct FiniteElementResult
{
  shape::Cells Solid;         ///< the tetrahedra
  Eigen::MatrixXd Values;     ///< values at their points
  double SecondsOfMesh = 0.0; ///< CPU time
  double SecondsOfFactor = 0.0;
};

/**
 * Computes the harmonic map with the given values at the points of a closed surface, by TetGen's
 * mesh, linear elements and one factorisation for the three coordinates. TetGen keeps the surface's
 * triangles, so the values are linear on each.
 *
 * Assembly visits the tetrahedra around each point, which requires no sorting and no repeated sums.
 * Only the triangle of the matrix that is factorised is assembled.
 */
FiniteElementResult SolveByFiniteElements(
  const shape::Mesh& surface, const Eigen::MatrixXd& values, const FiniteElementOptions& options);

} // namespace benchmark
