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
  Mesh Surface;         ///< the loop's points first, unchanged
  Eigen::MatrixXd Flat; ///< n x 2, counter-clockwise except where the layout folds
};

/// A patch's layout as a surface in the plane z = 0.
Mesh BuildFlatSurface(const HolePatch& patch);

/// The wanted edge lengths of a patch, and the edges that it must not have.
struct PatchSizes
{
  Eigen::VectorXd Loop;                  ///< k: wanted at the loop's points, > 0; smooth in between
  double Growth = 0.0;                   ///< of the edge length per distance from the loop
  int MaximumPoints = 100000;            ///< Growth is raised until about this many suffice
  std::function<bool(int, int)> IsTaken; ///< see FlatDiskOptions
  std::function<bool(int, int)> IsOutside; ///< see FlatDiskOptions
};

/// Edge lengths at the points of a loop: of the edges beside each, smoothed along the loop.
Eigen::VectorXd ComputeBoundarySizes(const Eigen::MatrixXd& loop);

/// The membrane of a loop. Its layout is a disk: the loop as a circle with the same edge lengths,
/// and points of a triangular grid inside, coarser away from the loop whatever sizes.Growth.
HolePatch BuildMembranePatch(
  const Eigen::MatrixXd& loop, const PatchSizes& sizes, const Progress& progress = {});

/**
 * The same surface with other triangles, of the wanted size. The layout is the conformal map that
 * keeps the loop's edge lengths (FlattenConformally), as in Schmidt and Singh, "Drag-and-drop
 * surface composition", section 4.1; if its outline crosses itself, the patch's own. New points are
 * in the old triangles, which are curved to normals that at the loop are `loopNormals` (k x 3), or
 * flat if there are none (0 x 3). Throws Aborted.
 */
HolePatch RemeshPatch(const HolePatch& patch, const PatchSizes& sizes,
  const Eigen::MatrixXd& loopNormals, const Progress& progress = {});

/// The maximum ratio between the edge lengths of two surfaces of the same triangles, relative to
/// the mean ratio; >= 1.
double ComputeMaximumStretch(const Mesh& one, const Mesh& other);

} // namespace shape
