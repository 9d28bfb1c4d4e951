#pragma once

#include "Base/Progress.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Linear/SparseSolve.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

namespace shape
{

/**
 * Approximate geodesic distances from many sets of seeds over one factorisation: heat flows for a
 * short time, its gradient is made of unit length, and the function with the gradient nearest to
 * that is the distance (Crane, Weischedel and Wardetzky, "Geodesics in heat", 2013, algorithm 1),
 * on the intrinsic Delaunay triangulation. On a surface with boundary it is the mean of the heat
 * under Neumann and under Dirichlet conditions there (section 3.4 of the paper).
 *
 * The time is the square of the mean edge length, as in the paper, or of a 300th of the surface's
 * extent along it if that is longer: the heat farther away would be less than any number.
 */
class HeatGeodesics
{
public:
  /// surface: a consistently oriented 2-manifold, open or closed. Throws SolveFailure, Aborted.
  explicit HeatGeodesics(const Surface& surface, const Progress& progress = {});

  /// n distances in the model's units from the nearest of the positions, >= 0; infinite on
  /// components without one.
  Eigen::VectorXd Distances(const SurfacePoints& seeds) const;

  /// The same from c sets at once: columns of how much of a seed is at each point, n x c, >= 0.
  Eigen::MatrixXd Distances(const Eigen::MatrixXd& seeds) const;

private:
  /// The integral of the normalised negative gradient of the heat against each point's hat
  /// function.
  Eigen::VectorXd Divergence(const Eigen::VectorXd& heat) const;
  /// Shifts solutions so that the minimum on each component with a seed is 0.
  void Begin(
    const Eigen::Ref<const Eigen::VectorXd>& seeds, Eigen::Ref<Eigen::VectorXd> distances) const;

  const Eigen::MatrixXi Given; ///< the surface's triangles
  std::shared_ptr<const IntrinsicLaplacian> Laplacian;
  Eigen::MatrixXd
    Corners; ///< m x 3, of the triangles laid flat: x of the second, x and y of the third
  Eigen::VectorXi ComponentId;
  Eigen::VectorXd Inside; ///< 1; 0 on the boundary
  SparseCholesky Heat, Poisson;
  std::optional<SparseCholesky> HeatWithin; ///< with Dirichlet conditions, if there is a boundary
};

/// The solver of a surface, which is built once and kept with it. Arguments and exceptions as
/// above.
std::shared_ptr<const HeatGeodesics> GetHeatGeodesics(
  const Surface& surface, const Progress& progress = {});

/// n x s: the distances from each of s points that have a triangle; infinite as above. Throws
/// SolveFailure, Aborted.
Eigen::MatrixXd ComputeHeatDistances(
  const Surface& surface, const std::vector<int>& points, const Progress& progress = {});

} // namespace shape
