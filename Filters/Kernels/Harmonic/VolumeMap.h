#pragma once

#include "Base/Progress.h"
#include "Harmonic/HarmonicMapTypes.h"
#include "Harmonic/PiecewiseVolumeMap.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace shape
{

struct AcceleratedSetup;

/// The conditions that a volume map has to meet.
struct VolumeMapConditions
{
  Surface Boundary;                   ///< closed: around the solid and its voids
  Eigen::MatrixXd Targets;            ///< n x 3: the images of its points
  std::optional<Surface> Target;      ///< the surface that the boundary is mapped to
  std::vector<ExactSurface> Surfaces; ///< inside; exact: see VolumeMapOptions::Exact
  VolumeFeatures Features;            ///< inside; fitted in the least-squares sense
};

struct VolumeMapOptions
{
  HarmonicVolumeMapOptions Harmonic;
  /// Solves one harmonic map in each region between the Surfaces, instead of one for the whole
  /// solid.
  bool Exact = false;
  /// Lets the images of the boundary's points slide on the Target, which must be given.
  bool FreeBoundary = false;
};

struct VolumeMapResult
{
  PiecewiseVolumeMapResult Map; ///< without Exact: a map of one region
  Eigen::MatrixXd Targets; ///< n x 3: the images of the boundary's points, given or after sliding
  /// Distance of the given Targets from the Target (ComputeTargetDistance); 0 without a Target.
  double TargetDistance = 0.0;
  // With FreeBoundary: see FreeBoundaryResult.
  double DistortionBefore = 0.0, DistortionAfter = 0.0;
  bool Slid = false; ///< whether sliding lowered the distortion
};

/**
 * Computes the map of a solid from given conditions. It chooses which solvers run, and in which
 * order:
 *
 * 1. With a Target: ComputeTargetDistance, which rejects a Target of a different topology.
 * 2. Without Exact, or with FreeBoundary: ComputeHarmonicVolumeMap, one map of the whole solid.
 * 3. With FreeBoundary: SlideBoundary, which starts from that map.
 * 4. With Exact: ComputePiecewiseVolumeMap, with the boundary's images after step 3.
 *
 * A fold-free mesh is made afterwards, from the points that the map has moved: ComputeFoldFreeMap.
 *
 * setup: see ComputeHarmonicVolumeMap. Throws InvalidInput if FreeBoundary is set without a Target,
 * and the exceptions of these functions.
 */
VolumeMapResult ComputeVolumeMap(const VolumeMapConditions& conditions,
  const VolumeMapOptions& options = {}, const Progress& progress = {},
  AcceleratedSetup* setup = nullptr);

} // namespace shape
