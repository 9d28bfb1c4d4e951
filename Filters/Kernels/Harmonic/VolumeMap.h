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

/// What a volume map is to meet.
struct VolumeMapConditions
{
  Surface Boundary;                   ///< closed: around the solid and its voids
  Eigen::MatrixXd Targets;            ///< n x 3: the images of its points
  std::optional<Surface> Target;      ///< the surface that the boundary goes to
  std::vector<ExactSurface> Surfaces; ///< inside, met exactly: see VolumeMapOptions::Exact
  VolumeFeatures Features;            ///< inside, met in the least-squares sense
};

struct VolumeMapOptions
{
  HarmonicVolumeMapOptions Harmonic;
  /// One harmonic map in each region between the Surfaces, instead of one map of the whole solid.
  bool Exact = false;
  /// The images of the boundary's points slide on the Target, which must be given.
  bool FreeBoundary = false;
};

struct VolumeMapResult
{
  PiecewiseVolumeMapResult Map; ///< of one region without Exact
  Eigen::MatrixXd Targets;      ///< n x 3: the images of the boundary's points: given, or slid
  /// How far the given Targets are from the Target (ComputeTargetDistance); 0 without a Target.
  double TargetDistance = 0.0;
  // With FreeBoundary: as in FreeBoundaryResult.
  double DistortionBefore = 0.0, DistortionAfter = 0.0;
  bool Slid = false; ///< the distortion became lower
};

/**
 * The map of a solid that given conditions determine: which solvers run, and in which order.
 *
 * 1. With a Target: ComputeTargetDistance, which refuses one of another topology.
 * 2. Without Exact, or with FreeBoundary: ComputeHarmonicVolumeMap, one map of the whole solid.
 * 3. With FreeBoundary: SlideBoundary, which starts from that map.
 * 4. With Exact: ComputePiecewiseVolumeMap, with the images that the boundary has by then.
 *
 * A fold-free mesh of the solid is made after that, from the points that the map has moved:
 * ComputeFoldFreeMap.
 *
 * Throws InvalidInput if FreeBoundary has no Target, and as these functions do. setup: of
 * ComputeHarmonicVolumeMap.
 */
VolumeMapResult ComputeVolumeMap(const VolumeMapConditions& conditions,
  const VolumeMapOptions& options = {}, const Progress& progress = {},
  AcceleratedSetup* setup = nullptr);

} // namespace shape
