#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The footprint of a feature: its loop in the plane. The exponential map around a seed maps the
 * surface under the feature, which is the fill of its hole, to the plane. If the loop crosses
 * itself there, the layout is conformal instead (FlattenPatchConformally).
 */
struct FeatureFootprint
{
  std::vector<int> Loop; ///< n points of the feature, in the order in which its triangles run
  /// n x 2: images of these points in the plane; the seed is the origin.
  Eigen::MatrixXd LoopPositions;
  Eigen::MatrixXd Normals;   ///< n x 3: normals at the loop of the surface under the feature
  Eigen::RowVector3d Normal; ///< of the plane, at the position where the feature was cut
  Eigen::RowVector3d XAxis;  ///< of the plane, at the same position
  /// Radius of the patch that was flattened conformally; 0 if the layout is the exponential map.
  double ConformalRadius = 0.0;
  bool IsRefined = false; ///< whether that layout has minimum distortion
  /// Whether the loop returns to its position if it is pasted on the surface from which it was cut,
  /// as tested. False if that surface is not a manifold, or if no layout returns it.
  bool ReturnsInPlace = false;
};

/// Returns whether a closed polygon (n x 2) neither crosses nor touches itself.
bool IsSimplePolygon(const Eigen::MatrixXd& polygon);

} // namespace shape
