#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * What a feature stands on: the surface under it, laid out in the plane by the exponential map
 * around a seed, as it is where the feature was cut and the hole filled. Where that map makes the
 * loop cross itself the layout is conformal instead (FlattenPatchConformally).
 */
struct FeatureFootprint
{
  std::vector<int> Loop;         ///< n points of the feature, as its triangles run through them
  Eigen::MatrixXd LoopPositions; ///< n x 2: where they are in the plane; the seed is the origin
  Eigen::MatrixXd Normals;       ///< n x 3: of the surface under the feature, at the loop
  Eigen::RowVector3d Normal;     ///< of the plane, where the feature is
  Eigen::RowVector3d XAxis;      ///< of the plane, likewise
  /// Of the patch that was laid out conformally; 0 where the layout is the exponential map's.
  double ConformalRadius = 0.0;
  bool IsRefined = false; ///< whether that layout is the one with the least distortion
  /// Whether the loop, set down here on the surface that it is from, comes back to its place: tried
  /// out. Not where that is no manifold, or no layout brings it back.
  bool ReturnsInPlace = false;
};

/// Whether a closed polygon (n x 2) neither crosses nor touches itself.
bool IsSimplePolygon(const Eigen::MatrixXd& polygon);

} // namespace shape
