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
  DistortionStatistics ConformalDistortion; ///< over the sound triangles; 1 if angles are preserved
  DistortionStatistics SymmetricDirichlet;  ///< over the sound triangles; 4 for an isometry
  /// area of the images of sound triangles, divided by the area of a disk with the patch's radius
  double Coverage = 0.0;
  bool Overlaps = false; ///< see IsOverlappingItself, AreSamplesOverlapping
  /// t values: MapMeasure::ConformalDistortion of each triangle
  Eigen::VectorXd ConformalDistortions;
  /// t values: MapMeasure::SymmetricDirichlet of each triangle
  Eigen::VectorXd SymmetricDirichlets;
};

/// Computes the quality of a patch's image. In a sampled surface, triangles count by their shares
/// (SampledSurface::Shares) in areas. radius: the patch's radius. Throws Aborted.
ExponentialFacts ComputeExponentialFacts(const Surface& surface, const ExponentialPatch& patch,
  double radius, const Progress& progress = {});

/// Whether distant parts of the image overlap: after the torn triangles are removed, a boundary
/// edge runs through a counter-clockwise triangle. Inner folds are not counted; they appear as
/// flipped triangles.
bool IsOverlappingItself(const ExponentialPatch& patch);

/// Whether distant parts of the image of a sampled surface overlap: the images of two points are
/// closer than half of the longest edge of one of them, but in space the points are farther apart
/// than twice this edge. Edges are those of triangles that are not torn.
bool AreSamplesOverlapping(const Surface& surface, const ExponentialPatch& patch);

/// Returns the patch as a mesh, with points and triangles in the order of the patch.
Mesh BuildPatchSurface(const Surface& surface, const ExponentialPatch& patch);

struct PatchLayoutOptions : ExponentialMapOptions
{
  /// At least 1e-9 of the diagonal of the surface's bounding box; if 0, a tenth of the diagonal.
  double Radius = 0.0;
  /// Whether RepairFlips moves the points around flipped triangles; not for sampled surfaces, whose
  /// triangles overlap.
  bool MendFlips = false;
};

struct PatchLayout
{
  ExponentialPatch Patch;
  /// the points and cells of the surface from which the patch's mesh comes
  shape::Provenance Provenance;
  ExponentialFacts Facts;
  double Radius = 0.0;
  double SeedDistance = 0.0; ///< distance of the given position from the surface
  int Mended = 0;            ///< number of triangles that RepairFlips repaired
};

/// Computes the patch around the surface position closest to `seed`, and its quality. map:
/// constructed with the same options. Throws InvalidInput when ExponentialMap::Around does, or if
/// no point of the surface lies within the radius, or if MendFlips is set for a sampled surface;
/// Aborted.
PatchLayout FlattenPatch(ExponentialMap& map, const Eigen::RowVector3d& seed,
  const Eigen::RowVector3d& xDirection, const PatchLayoutOptions& options = {},
  const Progress& progress = {});

} // namespace shape
