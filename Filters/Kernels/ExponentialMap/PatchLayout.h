#pragma once

#include "Base/Progress.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Quantiles of a measure over an area.
struct DistortionStatistics
{
  double Median = 0.0;
  double Percentile95 = 0.0;
};

/// How good a patch's image is. Sound triangles are those neither flipped nor torn.
struct ExponentialFacts
{
  double FlipRate = 0.0;                    ///< flipped triangles, torn or not, of all; 0 to 1
  DistortionStatistics ConformalDistortion; ///< over the sound triangles; 1: angles are kept
  DistortionStatistics SymmetricDirichlet;  ///< the same; 4: an isometry
  double Coverage = 0.0;                ///< area of the images of sound triangles over the disk's
  bool Overlaps = false;                ///< see IsOverlappingItself
  Eigen::VectorXd ConformalDistortions; ///< t: of each triangle, as EvaluateMapQuality has them
  Eigen::VectorXd SymmetricDirichlets;  ///< t
};

/// radius: of the disk. Throws Aborted.
ExponentialFacts ComputeExponentialFacts(const Surface& surface, const ExponentialPatch& patch,
  double radius, const Progress& progress = {});

/// Whether parts of the image that are not neighbours overlap: whether an edge of its boundary, or
/// of the boundary of its torn part, runs through the image of a sound triangle. Folds inside,
/// which flipped triangles show, do not count.
bool IsOverlappingItself(const ExponentialPatch& patch);

/// The patch as a mesh: its points and triangles, in their order.
Mesh BuildPatchSurface(const Surface& surface, const ExponentialPatch& patch);

struct PatchLayoutOptions : ExponentialMapOptions
{
  double Radius = 0.0;    ///< >= 0; 0: a tenth of the diagonal of the surface's box
  bool MendFlips = false; ///< whether RepairFlips then moves the points around flipped triangles
};

struct PatchLayout
{
  ExponentialPatch Patch;
  shape::Provenance Provenance; ///< of the patch as a mesh, from the surface
  ExponentialFacts Facts;
  double Radius = 0.0;
  double SeedDistance = 0.0; ///< of the position that was given from the surface
  int Mended = 0;            ///< triangles that RepairFlips has flipped back
};

/// The patch around the point of the surface closest to `seed`, and how good it is. map: with the
/// same options. Throws as ExponentialMap::Around does, and InvalidInput if no point lies within
/// the radius.
PatchLayout FlattenPatch(ExponentialMap& map, const Eigen::RowVector3d& seed,
  const Eigen::RowVector3d& xDirection, const PatchLayoutOptions& options = {},
  const Progress& progress = {});

} // namespace shape
