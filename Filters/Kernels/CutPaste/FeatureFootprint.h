#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * What a feature stands on: its loop in the plane. The surface under the feature, the fill of the
 * hole that it left, is mapped to the plane by the exponential map around a seed. If the loop
 * crosses itself there, the layout is conformal instead (FlattenPatchConformally).
 */
struct FeatureFootprint
{
  std::vector<int> Loop; ///< n points of the feature, in the order in which its triangles run
  Eigen::MatrixXd LoopPositions; ///< n x 2: their images in the plane; the seed is the origin
  Eigen::MatrixXd Normals;       ///< n x 3: of the surface under the feature, at the loop
  Eigen::RowVector3d Normal;     ///< of the plane, where the feature was cut
  Eigen::RowVector3d XAxis;      ///< of the plane, likewise
  /// Of the patch that was flattened conformally; 0 if the layout is the exponential map.
  double ConformalRadius = 0.0;
  bool IsRefined = false; ///< whether that layout is the one of minimum distortion
  /// Whether the loop, pasted on the surface that it was cut from, returns to its position: this
  /// was tested. False if that surface is no manifold, or if no layout returns it.
  bool ReturnsInPlace = false;
};

/// Whether a closed polygon (n x 2) neither crosses nor touches itself.
bool IsSimplePolygon(const Eigen::MatrixXd& polygon);

} // namespace shape
