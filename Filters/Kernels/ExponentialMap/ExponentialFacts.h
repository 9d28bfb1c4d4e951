#pragma once

#include "Base/Progress.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// What a share of an area does not exceed.
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
  double Coverage = 0.0;                ///< area of the images of sound triangles, of the disk's
  bool Overlaps = false;                ///< see IsOverlappingItself
  Eigen::VectorXd ConformalDistortions; ///< t: of each triangle, as EvaluateMapQuality has them
  Eigen::VectorXd SymmetricDirichlets;  ///< t
};

/// radius: of the disk. Throws Aborted.
ExponentialFacts ComputeExponentialFacts(
  const Mesh& surface, const ExponentialPatch& patch, double radius, const Progress& progress = {});

/// Whether parts of the image that are not next to each other lie over one another: whether an edge
/// of its rim, or of the rim of what is torn, runs through the image of a sound triangle. Folds
/// inside, which flipped triangles show, do not count.
bool IsOverlappingItself(const ExponentialPatch& patch);

/// The patch as a surface of its own: its points and triangles, in their order.
Mesh BuildPatchSurface(const Mesh& surface, const ExponentialPatch& patch);

} // namespace shape
