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
 * Computes approximate geodesic distances from many sets of seeds with one factorisation. Heat
 * flows for a short time, and its gradient is normalised to unit length. The distance is the
 * function whose gradient is closest to that field (Crane, Weischedel and Wardetzky, "Geodesics in
 * heat", 2013, algorithm 1), on the intrinsic Delaunay triangulation. On a surface with boundary,
 * the heat is the mean of the solutions with Neumann and with Dirichlet conditions (section 3.4).
 *
 * The time is the square of the mean edge length, as in the paper, or of 1/300 of the surface's
 * extent along edges if that is longer. With a shorter time the heat far away would underflow.
 */
class HeatGeodesics
{
public:
  /// surface: a consistently oriented 2-manifold, open or closed. Throws SolveFailure, Aborted.
  explicit HeatGeodesics(const Surface& surface, const Progress& progress = {});

  /// Returns n distances in the model's units from the nearest of the positions, >= 0; infinite on
  /// components without a seed.
  Eigen::VectorXd Distances(const SurfacePoints& seeds) const;

  /// Returns the same for c sets at once. seeds: n x c, >= 0, the share of a seed at each point.
  Eigen::MatrixXd Distances(const Eigen::MatrixXd& seeds) const;

private:
  /// Returns the integral of the normalised negative heat gradient against each point's hat
  /// function.
  Eigen::VectorXd Divergence(const Eigen::VectorXd& heat) const;
  /// Shifts the distances so that their minimum on each component with a seed is 0.
  void Begin(
    const Eigen::Ref<const Eigen::VectorXd>& seeds, Eigen::Ref<Eigen::VectorXd> distances) const;

  const Eigen::MatrixXi Given; ///< the surface's triangles
  std::shared_ptr<const IntrinsicLaplacian> Laplacian;
  Eigen::MatrixXd
    Corners; ///< m x 3, triangles in the plane: x of the second corner, x and y of the third
  Eigen::VectorXi ComponentId;
  Eigen::VectorXd Inside; ///< 1 inside, 0 on the boundary
  SparseCholesky Heat, Poisson;
  std::optional<SparseCholesky> HeatWithin; ///< with Dirichlet conditions; empty without a boundary
};

/// Returns the solver of a surface, which is built once and cached in the surface. Arguments and
/// exceptions as for HeatGeodesics.
std::shared_ptr<const HeatGeodesics> GetHeatGeodesics(
  const Surface& surface, const Progress& progress = {});

/// Returns the distances from each of s points that have a triangle: n x s; infinite on other
/// components. Throws SolveFailure, Aborted.
Eigen::MatrixXd ComputeHeatDistances(
  const Surface& surface, const std::vector<int>& points, const Progress& progress = {});

} // namespace shape
