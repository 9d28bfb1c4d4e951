#pragma once

#include "Base/Progress.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Area-weighted quantiles of a measure.
struct DistortionStatistics
{
  double Median = 0.0;
  double Percentile95 = 0.0;
};

/// Quality of a patch's image. Sound triangles are those neither flipped nor torn.
struct ExponentialFacts
{
  double FlipRate = 0.0; ///< flipped triangles, torn or not / all triangles; 0 to 1
  DistortionStatistics ConformalDistortion; ///< over the sound triangles; 1 if angles are preserved
  DistortionStatistics SymmetricDirichlet;  ///< over the sound triangles; 4 for an isometry
  double Coverage = 0.0; ///< area of the images of sound triangles / area of the disk
  bool Overlaps = false; ///< see IsOverlappingItself
  Eigen::VectorXd ConformalDistortions; ///< t: for each triangle, as in EvaluateMapQuality
  Eigen::VectorXd SymmetricDirichlets;  ///< t: for each triangle
};

/// Computes the quality of a patch's image. radius: of the disk. Throws Aborted.
ExponentialFacts ComputeExponentialFacts(const Surface& surface, const ExponentialPatch& patch,
  double radius, const Progress& progress = {});

/// Whether distant parts of the image overlap: an edge of its boundary, or of the boundary of its
/// torn part, runs through the image of a sound triangle. Inner folds, which appear as flipped
/// triangles, are not counted.
bool IsOverlappingItself(const ExponentialPatch& patch);

/// Returns the patch as a mesh: its points and triangles, in their order.
Mesh BuildPatchSurface(const Surface& surface, const ExponentialPatch& patch);

struct PatchLayoutOptions : ExponentialMapOptions
{
  double Radius = 0.0;    ///< >= 0; 0: a tenth of the diagonal of the surface's box
  bool MendFlips = false; ///< whether RepairFlips moves the points around flipped triangles
};

struct PatchLayout
{
  ExponentialPatch Patch;
  shape::Provenance Provenance; ///< of the patch as a mesh, from the surface
  ExponentialFacts Facts;
  double Radius = 0.0;
  double SeedDistance = 0.0; ///< distance of the given position from the surface
  int Mended = 0;            ///< number of triangles that RepairFlips repaired
};

/// Computes the patch around the surface point closest to `seed`, and its quality. map: built with
/// the same options. Throws as ExponentialMap::Around, and InvalidInput if no point lies within the
/// radius.
PatchLayout FlattenPatch(ExponentialMap& map, const Eigen::RowVector3d& seed,
  const Eigen::RowVector3d& xDirection, const PatchLayoutOptions& options = {},
  const Progress& progress = {});

} // namespace shape
