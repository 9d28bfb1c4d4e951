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
 * The time is the square of the mean edge length, as in the paper. If 1/300 of an upper bound of
 * the surface's diameter (along edges) is longer than the mean edge length, the time is the square
 * of this 300th. With a shorter time, the heat far away would underflow.
 */
class HeatGeodesics
{
public:
  /// surface: triangles; if they are no oriented manifold, the tufted cover is used
  /// (GetIntrinsicLaplacian). Throws SolveFailure, Aborted.
  explicit HeatGeodesics(const Surface& surface, const Progress& progress = {});

  /// Returns the n distances of the surface's points from the nearest seed, in the model's units.
  /// They are >= 0, and infinite on components without a seed.
  Eigen::VectorXd Distances(const SurfacePoints& seeds) const;

  /// Returns the distances (n x c) from c sets of seeds. seeds: n x c values >= 0; each column is a
  /// set, and a value is the weight of the seeds at a point.
  Eigen::MatrixXd Distances(const Eigen::MatrixXd& seeds) const;

private:
  /// Returns, for each point, the integrated divergence of the normalised negative heat gradient.
  Eigen::VectorXd Divergence(const Eigen::VectorXd& heat) const;
  /// Shifts the distances so that their minimum on each component with a seed is 0.
  void Begin(
    const Eigen::Ref<const Eigen::VectorXd>& seeds, Eigen::Ref<Eigen::VectorXd> distances) const;

  const Eigen::MatrixXi Given; ///< the surface's triangles
  std::shared_ptr<const IntrinsicLaplacian> Laplacian;
  /// m x 3: each triangle in the plane, given by x of its second corner, and x and y of its third
  Eigen::MatrixXd Corners;
  Eigen::VectorXi ComponentId;
  Eigen::VectorXd Inside; ///< n values: 1 inside, 0 on the boundary
  SparseCholesky Heat, Poisson;
  std::optional<SparseCholesky> HeatWithin; ///< with Dirichlet conditions; empty without a boundary
};

/// Returns the solver of a surface, which is built once and cached in the surface. Takes the same
/// arguments and throws the same exceptions as the constructor of HeatGeodesics.
std::shared_ptr<const HeatGeodesics> GetHeatGeodesics(
  const Surface& surface, const Progress& progress = {});

/// Returns the distances of all points from each of s points (n x s), infinite on other components.
/// Each of the s points must be a corner of a triangle. Throws SolveFailure, Aborted.
Eigen::MatrixXd ComputeHeatDistances(
  const Surface& surface, const std::vector<int>& points, const Progress& progress = {});

} // namespace shape
