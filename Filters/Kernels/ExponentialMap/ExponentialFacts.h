#pragma once

#include "Mesh/Mesh.h"
#include "Base/Progress.h"
#include "ExponentialMap/ExponentialMap.h"

#include <Eigen/Core>

namespace shape
{

/// What a share of an area does not exceed.
struct DistortionSpread
{
  double Median = 0.0;
  double Percentile95 = 0.0;
};

/// How good a patch's image is. Sound triangles are those neither flipped nor torn.
struct ExponentialFacts
{
  double FlipRate = 0.0;                ///< flipped triangles, torn or not, of all; 0 to 1
  DistortionSpread ConformalDistortion; ///< over the sound triangles; 1: angles are kept
  DistortionSpread SymmetricDirichlet;  ///< the same; 4: an isometry
  double Coverage = 0.0;                ///< area of the images of sound triangles, of the disk's
  bool Overlaps = false;                ///< see OverlapsItself
  Eigen::VectorXd ConformalDistortions; ///< t: of each triangle, as MapQuality has them
  Eigen::VectorXd SymmetricDirichlets;  ///< t
};

/// radius: of the disk. Throws Aborted.
ExponentialFacts FactsOf(
  const Mesh& surface, const ExponentialPatch& patch, double radius, const Progress& progress = {});

/// Whether parts of the image that are not next to each other lie over one another: whether an edge
/// of its rim, or of the rim of what is torn, runs through the image of a sound triangle. Folds
/// inside, which flipped triangles show, do not count.
bool OverlapsItself(const ExponentialPatch& patch);

/// The patch as a surface of its own: its points and triangles, in their order.
Mesh PatchSurface(const Mesh& surface, const ExponentialPatch& patch);

} // namespace shape
