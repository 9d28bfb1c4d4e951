#pragma once

#include "Base/Progress.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Linear/SparseSolve.h"
#include "Mesh/Mesh.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace shape
{

/**
 * Approximate geodesic distances from many sets of seeds over one factorisation: heat flows for a
 * short time, its gradient is made of unit length, and the function with the gradient nearest to
 * that is the distance (Crane, Weischedel and Wardetzky, "Geodesics in heat", 2013, algorithm 1),
 * on the intrinsic Delaunay triangulation. On a surface with border the mean of the heat that the
 * border holds back and the heat that it lets go is taken (section 3.4 there).
 *
 * The time is the square of the mean side, as there, or of a 300th of the surface's extent along it
 * where that is longer: farther heat would be less than any number.
 */
class HeatGeodesics
{
public:
  /// mesh: a consistently oriented 2-manifold, open or closed. Throws SolveFailure, Aborted.
  explicit HeatGeodesics(const Mesh& mesh, const Progress& progress = {});

  /// n distances in the model's units from the nearest of the places, 0 at the least; infinite
  /// where a component has none.
  Eigen::VectorXd Distances(const SurfacePoints& seeds) const;

  /// The same from c sets at once: columns of how much of a seed is at each point, n x c, >= 0.
  Eigen::MatrixXd Distances(const Eigen::MatrixXd& seeds) const;

private:
  /// The integral of the normalised negative gradient of the heat against each point's hat
  /// function.
  Eigen::VectorXd Divergence(const Eigen::VectorXd& heat) const;
  /// Shifts solutions so that the least of each component with a seed is 0.
  void Begin(
    const Eigen::Ref<const Eigen::VectorXd>& seeds, Eigen::Ref<Eigen::VectorXd> distances) const;

  const Eigen::MatrixXi Given; ///< the mesh's triangles
  IntrinsicTriangles Flat;
  Eigen::MatrixXd
    Corners; ///< m x 3, of the triangles laid flat: x of the second, x and y of the third
  Eigen::VectorXi ComponentId;
  Eigen::VectorXd Inside; ///< 1; 0 on the border
  SparseCholesky Heat, Poisson;
  std::optional<SparseCholesky> HeatWithin; ///< let go at the border, where there is one
};

/// n x s: those from each of s points that have a triangle; infinite as above. Throws SolveFailure,
/// Aborted.
Eigen::MatrixXd ComputeHeatDistances(
  const Mesh& mesh, const std::vector<int>& points, const Progress& progress = {});

} // namespace shape
