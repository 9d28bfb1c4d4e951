#pragma once

#include "Base/Progress.h"
#include "Harmonic/FiniteElementMap.h"
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
  std::vector<ExactSurface> Surfaces; ///< inside the boundary, for VolumeMapOptions::Exact
  VolumeFeatures Features;            ///< inside the boundary, fitted by least squares
};

struct VolumeMapOptions
{
  HarmonicVolumeMapOptions Harmonic;
  /// Whether to solve one harmonic map in each region between the Surfaces, instead of one for the
  /// whole solid.
  bool Exact = false;
  /// Whether the images of the boundary's points may slide on the Target, which must be given then.
  bool FreeBoundary = false;
};

struct VolumeMapResult
{
  PiecewiseVolumeMapResult Map; ///< without Exact: a map of one region
  /// With FiniteElements: the map. Map then has the errors, and no charges.
  std::optional<FiniteElements> Elements;
  Eigen::MatrixXd Targets; ///< n x 3: images of the boundary's points, as given or after sliding
  /// Distance between the given Targets and the Target (ComputeTargetDistance); 0 without a Target.
  double TargetDistance = 0.0;
  // With FreeBoundary: see FreeBoundaryResult.
  double DistortionBefore = 0.0, DistortionAfter = 0.0, FoldedBefore = 0.0, FoldedAfter = 0.0;
  double SlidShare = 0.0;
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
 * FiniteElements is one map of the whole solid (ComputeFiniteElements) and has step 1 only. It
 * takes no features, and neither Exact nor FreeBoundary.
 *
 * ComputeFoldFreeMap can then make a fold-free mesh from the points that the map has moved.
 *
 * setup: see ComputeHarmonicVolumeMap. Throws the exceptions of these functions, and InvalidInput
 * if FreeBoundary is set without a Target, or if FiniteElements cannot meet a condition.
 */
VolumeMapResult ComputeVolumeMap(const VolumeMapConditions& conditions,
  const VolumeMapOptions& options = {}, const Progress& progress = {},
  AcceleratedSetup* setup = nullptr);

} // namespace shape
