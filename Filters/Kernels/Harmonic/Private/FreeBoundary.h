#pragma once

#include "Base/Progress.h"
#include "Harmonic/HarmonicMapTypes.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct FreeBoundaryResult
{
  Eigen::MatrixXd Targets;     ///< n x 3: the images of the boundary's points, on the target
  HarmonicVolumeMapResult Map; ///< the harmonic map with these values
  /// Means over the solid's volume of the symmetric Dirichlet energy |J|^2 + |J^-1|^2 of the
  /// harmonic map, images scaled so that the volumes of solid and target agree: 6 for an isometry.
  double DistortionBefore = 0.0, DistortionAfter = 0.0;
  bool Kept = false; ///< whether it became less: else Targets and Map are what was given
};

/**
 * Lets the images of a boundary's points slide on the target surface, so that the volume map is
 * distorted less: the solid's tetrahedra, carried by the harmonic map and untangled, lower their
 * elliptic energy (EllipticEnergy) with the points of the boundary on the target; then the harmonic
 * map with these values is solved. Creases of the target do not hold points.
 *
 * boundary, targets, features, options: of ComputeHarmonicVolumeMap; map: its result. Throws what
 * that, Tetrahedralize and Untangle throw; SolveFailure if tetrahedra stay inverted, as they do
 * if the boundary map folds; Aborted.
 */
FreeBoundaryResult SlideBoundary(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const VolumeFeatures& features, const HarmonicVolumeMapOptions& options,
  const HarmonicVolumeMapResult& map, const Progress& progress = {});

} // namespace shape
