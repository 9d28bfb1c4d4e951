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
  /// Mean of the symmetric Dirichlet energy |J|^2 + |J^-1|^2 of the harmonic map over the part of
  /// the solid where it does not fold. For this, images are scaled so that solid and target have
  /// the same volume. The energy of an isometry is 6. At most LargestMeasure, which it is if the
  /// map folds everywhere.
  double DistortionBefore = 0.0, DistortionAfter = 0.0;
  /// Share of the solid's volume where the map folds: det J <= 0. In [0, 1]. If it is not 0, the
  /// energy has no finite mean over the whole solid.
  double FoldedBefore = 0.0, FoldedAfter = 0.0;
  /// Share of the way that the images slid, in [0, 1]. If it is 0, Targets and Map equal the given
  /// ones.
  double Share = 0.0;
};

/**
 * Reduces the distortion of a volume map by letting the images of the boundary's points slide on
 * the target surface. The solid is filled with at least about 20,000 tetrahedra. The images slide
 * to lower the energy of the tetrahedra's harmonic map, which is linear in the images
 * (SlideImages). Then the harmonic map with the new boundary values is solved.
 *
 * Both maps are judged by the derivative of their formula at 20,000 positions inside that the
 * sliding does not use (SampleTetrahedra). The new map is kept if its distortion is lower and it
 * folds at no larger share of the positions. If not, the images go only 3/4, 1/2 or 1/4 of the way.
 * Points may slide across creases of the target.
 *
 * boundary, targets, features, options: as for ComputeHarmonicVolumeMap. map: the result of
 * ComputeHarmonicVolumeMap. Throws the exceptions of ComputeHarmonicVolumeMap, Tetrahedralize and
 * SlideImages; Aborted.
 */
FreeBoundaryResult SlideBoundary(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const VolumeFeatures& features, const HarmonicVolumeMapOptions& options,
  const HarmonicVolumeMapResult& map, const Progress& progress = {});

} // namespace shape
