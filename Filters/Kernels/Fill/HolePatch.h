#pragma once

#include "Base/Progress.h"
#include "Fill/FairSurface.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

/// A surface with a given boundary loop, and its layout in the plane.
struct HolePatch
{
  Mesh Surface;         ///< the points of the loop first, unchanged
  Eigen::MatrixXd Flat; ///< n x 2, counter-clockwise except where the layout folds
};

/// Returns a patch's layout as a surface in the plane z = 0.
Mesh BuildFlatSurface(const HolePatch& patch);

/// The wanted edge lengths of a patch, and the edges that it must not contain.
struct PatchSizes
{
  Eigen::VectorXd Loop;       ///< k: wanted lengths at the loop's points, > 0; smooth in between
  double Growth = 0.0;        ///< growth of the edge length per distance from the loop
  int MaximumPoints = 100000; ///< Growth is raised until about this many suffice
  std::function<bool(int, int)> IsTaken;   ///< see FlatDiskOptions
  std::function<bool(int, int)> IsOutside; ///< see FlatDiskOptions
};

/// Returns the edge length at each point of a loop: that of the adjacent edges, smoothed along the
/// loop.
Eigen::VectorXd ComputeBoundarySizes(const Eigen::MatrixXd& loop);

/// Builds the membrane of a loop. Its layout is a disk: the loop becomes a circle with the same
/// edge lengths. The points inside are those of a triangular grid, which is coarser away from the
/// loop for any sizes.Growth.
HolePatch BuildMembranePatch(
  const Eigen::MatrixXd& loop, const PatchSizes& sizes, const Progress& progress = {});

/**
 * Returns the same surface with triangles of the wanted size. The layout is the conformal map that
 * keeps the loop's edge lengths (FlattenConformally), as in Schmidt and Singh, "Drag-and-drop
 * surface composition", section 4.1. If its outline crosses itself, the patch's layout is used. New
 * points lie in the old triangles. These are curved to normals that equal `loopNormals` (k x 3) at
 * the loop, or flat if there are none (0 x 3). Throws Aborted.
 */
HolePatch RemeshPatch(const HolePatch& patch, const PatchSizes& sizes,
  const Eigen::MatrixXd& loopNormals, const Progress& progress = {});

/// Returns the maximum ratio between the edge lengths of two surfaces with the same triangles,
/// relative to the mean ratio; >= 1.
double ComputeMaximumStretch(const Mesh& one, const Mesh& other);

} // namespace shape
