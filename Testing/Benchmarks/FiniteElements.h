#pragma once

#include "Mesh/Cells.h"
#include "Mesh/Mesh.h"

#include <string>

// The Laplace equation by finite elements: what one would do without ShapeMap.
namespace benchmark
{

struct FiniteElementOptions
{
  /// The bound on a tetrahedron's volume is such that the mean one becomes about this times smaller
  /// than 1 / (6 n) of the solid; 0 for no bound.
  double Refine = 0.0;
  double RadiusEdgeRatio = 2.0; ///< TetGen's own default
  /// CHOLMOD (supernodal, OpenBLAS), LLT or LDLT (Eigen's simplicial ones), or CG (Eigen's
  /// conjugate gradients with incomplete Cholesky, to 1e-8).
  std::string Solver = "CHOLMOD";
  std::string Ordering = "AMD"; ///< of CHOLMOD: AMD, METIS or Best (of both)
};

struct FiniteElementResult
{
  shape::Cells Solid;         ///< the tetrahedra
  Eigen::MatrixXd Values;     ///< at their points
  double SecondsOfMesh = 0.0; ///< CPU
  double SecondsOfFactor = 0.0;
};

/**
 * The harmonic map with the values given at the points of a closed surface: TetGen's mesh, linear
 * elements, one factorisation for the three coordinates. TetGen keeps the surface's triangles, so
 * the values are linear on each.
 *
 * Assembly goes over the tetrahedra around each point, so nothing is sorted and nothing is summed
 * twice; only the triangle of the matrix that is factorised is made.
 */
FiniteElementResult SolveByFiniteElements(
  const shape::Mesh& surface, const Eigen::MatrixXd& values, const FiniteElementOptions& options);

} // namespace benchmark
