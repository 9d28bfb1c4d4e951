#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The footprint of a feature: its loop in the plane. The exponential map around a seed maps the
 * surface under the feature, which is the fill of its hole, to the plane. If the loop crosses
 * itself in the plane, the layout is conformal instead (FlattenPatchConformally).
 */
struct FeatureFootprint
{
  std::vector<int> Loop; ///< n: points of the feature, with the feature to the left
  /// n x 2: positions of the loop's points in the plane, with the seed at the origin.
  Eigen::MatrixXd LoopPositions;
  Eigen::MatrixXd Normals;   ///< n x 3: normals of the surface under the feature, at the loop
  Eigen::RowVector3d Normal; ///< normal of the plane, at the position where the feature was cut
  Eigen::RowVector3d XAxis;  ///< x axis of the plane, at the same position
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero(); ///< this position: the seed
  /// Radius of the patch that was flattened conformally; 0 if the layout is the exponential map.
  double ConformalRadius = 0.0;
  bool IsRefined = false; ///< whether the conformal layout has minimum distortion
  /// Whether a test has shown that the loop returns to its position when it is pasted on the
  /// surface from which it was cut. False if that surface is not a manifold, or if no layout
  /// returns the loop to its position.
  bool ReturnsInPlace = false;
};

/// A choice of the loops of a feature along which it is joined to a target.
struct JoinedLoops
{
  enum class LoopsType
  {
    One,
    All ///< all loops that were cut or, if the loop at the seed was not, all loops
  };
  LoopsType Loops = LoopsType::One;
  /// Index of the loop at the seed, in the order of FindBoundaryLoops. 0: the first loop that was
  /// cut or, if none was, the longest loop.
  int LoopIndex = 0;
};

bool operator==(const JoinedLoops& a, const JoinedLoops& b);

/// Returns the points of all loops, one loop after another.
std::vector<int> ConcatenateLoops(const std::vector<std::vector<int>>& loops);

/// Returns the base's x axis, rotated by the minimum rotation from the base's normal to `normal`.
Eigen::RowVector3d TurnAxis(const FeatureFootprint& base, const Eigen::RowVector3d& normal);

/// Returns whether a closed polygon (n x 2) neither crosses nor touches itself.
bool IsSimplePolygon(const Eigen::MatrixXd& polygon);

} // namespace shape
