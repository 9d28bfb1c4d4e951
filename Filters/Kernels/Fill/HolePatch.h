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
  Eigen::MatrixXd Flat; ///< n x 2; triangles are counter-clockwise unless the layout folds
};

/// Returns a patch's layout as a surface in the plane z = 0.
Mesh BuildFlatSurface(const HolePatch& patch);

/// The wanted edge lengths of a patch, and the edges that it must not contain.
struct PatchSizes
{
  Eigen::VectorXd Loop;       ///< k values: wanted edge lengths at the loop's points; > 0
  double Growth = 0.0;        ///< increase of the edge length per unit of distance from the loop
  int MaximumPoints = 100000; ///< Growth is raised until about this many points suffice
  std::function<bool(int, int)> IsTaken;   ///< see FlatDiskOptions
  std::function<bool(int, int)> IsOutside; ///< see FlatDiskOptions
};

/// Returns the edge length at each point of a loop: a weighted mean over the four edges before and
/// the four edges after it.
Eigen::VectorXd ComputeBoundarySizes(const Eigen::MatrixXd& loop);

/// Builds the membrane of a loop. Its layout is a disk: the loop becomes a circle with the same
/// edge lengths. Its inner points are those of a triangular grid. The grid becomes coarser away
/// from the loop, whatever sizes.Growth is.
HolePatch BuildMembranePatch(
  const Eigen::MatrixXd& loop, const PatchSizes& sizes, const Progress& progress = {});

/**
 * Returns the same surface with triangles of the wanted size. The layout is the conformal map that
 * keeps the loop's edge lengths (FlattenConformally), as in Schmidt and Singh, "Drag-and-drop
 * surface composition", section 4.1. If the outline of this layout crosses itself, the layout of
 * `patch` is used instead. New points lie on the old triangles, which are curved to agree with the
 * normals at their corners. At the loop, the normals are `loopNormals` (k x 3). If `loopNormals`
 * has no rows, the triangles are flat. Throws Aborted.
 */
HolePatch RemeshPatch(const HolePatch& patch, const PatchSizes& sizes,
  const Eigen::MatrixXd& loopNormals, const Progress& progress = {});

/// For two surfaces with the same triangles, computes for each edge the ratio of its two lengths.
/// Returns the largest factor (>= 1) by which a ratio differs from the geometric mean of all
/// ratios.
double ComputeMaximumStretch(const Mesh& one, const Mesh& other);

} // namespace shape
