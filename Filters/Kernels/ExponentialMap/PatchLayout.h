#pragma once

#include "Base/Progress.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Area-weighted quantiles of a distortion measure.
struct DistortionStatistics
{
  double Median = 0.0;
  double Percentile95 = 0.0;
};

/// Quality of a patch's image. A triangle is sound if it is neither flipped nor torn.
struct ExponentialFacts
{
  /// number of flipped triangles, torn or not, divided by the number of all triangles; 0 to 1
  double FlipRate = 0.0;
  DistortionStatistics ConformalDistortion; ///< of sound triangles; 1 if angles are preserved
  DistortionStatistics SymmetricDirichlet;  ///< of sound triangles; 4 for an isometry
  /// area of the images of sound triangles, divided by that of a disk with the patch's radius
  double Coverage = 0.0;
  bool Overlaps = false;                ///< see IsOverlappingItself
  Eigen::VectorXd ConformalDistortions; ///< t: MapMeasure::ConformalDistortion of each triangle
  Eigen::VectorXd SymmetricDirichlets;  ///< t: MapMeasure::SymmetricDirichlet of each triangle
};

/// Computes the quality of a patch's image. radius: the patch's radius. Throws Aborted.
ExponentialFacts ComputeExponentialFacts(const Surface& surface, const ExponentialPatch& patch,
  double radius, const Progress& progress = {});

/// Whether distant parts of the image overlap: a boundary edge of the part that is not torn runs
/// through a counter-clockwise triangle of this part. Inner folds are not counted; they appear as
/// flipped triangles.
bool IsOverlappingItself(const ExponentialPatch& patch);

/// Returns the patch as a mesh, with its points and triangles in their order.
Mesh BuildPatchSurface(const Surface& surface, const ExponentialPatch& patch);

struct PatchLayoutOptions : ExponentialMapOptions
{
  double Radius = 0.0;    ///< >= 0; 0: a tenth of the diagonal of the surface's bounding box
  bool MendFlips = false; ///< whether RepairFlips moves the points around flipped triangles
};

struct PatchLayout
{
  ExponentialPatch Patch;
  shape::Provenance Provenance; ///< where the patch, as a mesh, comes from on the surface
  ExponentialFacts Facts;
  double Radius = 0.0;
  double SeedDistance = 0.0; ///< distance of the given position from the surface
  int Mended = 0;            ///< number of triangles that RepairFlips repaired
};

/// Computes the patch around the surface position closest to `seed`, and its quality. map:
/// constructed with the same options. Throws InvalidInput when ExponentialMap::Around does, or if
/// no point of the surface lies within the radius; Aborted.
PatchLayout FlattenPatch(ExponentialMap& map, const Eigen::RowVector3d& seed,
  const Eigen::RowVector3d& xDirection, const PatchLayoutOptions& options = {},
  const Progress& progress = {});

} // namespace shape
