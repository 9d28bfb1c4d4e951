#pragma once

#include "Base/Progress.h"
#include "Fill/FairSurface.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

/// A surface that spans a rim, and the same disk laid out in the plane.
struct HolePatch
{
  Mesh Surface;         ///< the rim's points first, as they are
  Eigen::MatrixXd Flat; ///< n x 2, counter-clockwise but where the layout folds
};

/// A patch's layout as a surface in the plane z = 0.
Mesh BuildFlatSurface(const HolePatch& patch);

/// How long the edges of a patch become, and which must not be there.
struct PatchSizes
{
  Eigen::VectorXd Loop; ///< k: wanted at the rim's points, > 0; in between they change smoothly
  double Growth = 0.0;  ///< by how much edges grow with the distance from the rim
  int MaximumPoints = 100000;              ///< Growth is raised until about as many are enough
  std::function<bool(int, int)> IsTaken;   ///< see FlatDiskOptions
  std::function<bool(int, int)> IsOutside; ///< see FlatDiskOptions
};

/// Edge lengths at the points of a rim: those of the sides beside each, smoothed along the rim.
Eigen::VectorXd ComputeBoundarySizes(const Eigen::MatrixXd& loop);

/// The rim as a circle that keeps its sides' lengths, points on a triangular grid in it, coarser
/// away from the rim whatever sizes.Growth; and the membrane of that disk.
HolePatch BuildMembranePatch(
  const Eigen::MatrixXd& loop, const PatchSizes& sizes, const Progress& progress = {});

/**
 * The same surface with other triangles, as long as wanted. The layout is the conformal map with
 * the rim's lengths kept (FlattenConformally), as in Schmidt and Singh, "Drag-and-drop surface
 * composition", section 4.1; where that one's outline crosses itself the one that the patch has.
 * New points are in the old triangles, curved to the normals, which at the rim are `rimNormals`
 * (k x 3), or flat where there are none (0 x 3). Throws Aborted.
 */
HolePatch RemeshPatch(const HolePatch& patch, const PatchSizes& sizes,
  const Eigen::MatrixXd& loopNormals, const Progress& progress = {});

/// By how much the edges of two surfaces of the same triangles differ, where they differ most from
/// the mean.
double ComputeMaximumStretch(const Mesh& one, const Mesh& other);

} // namespace shape
