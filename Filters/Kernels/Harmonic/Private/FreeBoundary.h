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
  HarmonicVolumeMapResult Map; ///< the harmonic map with Targets as boundary values
  /// Mean of the symmetric Dirichlet energy |J|^2 + |J^-1|^2 of the harmonic map over the solid's
  /// volume. For this, images are scaled so that solid and target have the same volume. The energy
  /// of an isometry is 6.
  double DistortionBefore = 0.0, DistortionAfter = 0.0;
  /// whether the distortion decreased; if not, Targets and Map equal the given ones
  bool Kept = false;
};

/**
 * Reduces the distortion of a volume map by letting the images of the boundary's points slide on
 * the target surface. The solid is filled with at least about 20,000 tetrahedra. The images slide
 * to lower the energy of the tetrahedra's harmonic map, which is linear in the images
 * (SlideImages). Finally the harmonic map with the new boundary values is solved. Points may slide
 * across creases of the target.
 *
 * boundary, targets, features, options: as for ComputeHarmonicVolumeMap. map: the result of
 * ComputeHarmonicVolumeMap. Throws the exceptions of ComputeHarmonicVolumeMap, Tetrahedralize and
 * SlideImages; Aborted.
 */
FreeBoundaryResult SlideBoundary(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const VolumeFeatures& features, const HarmonicVolumeMapOptions& options,
  const HarmonicVolumeMapResult& map, const Progress& progress = {});

} // namespace shape
