#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The handle by which a shape is deformed: a closed or open curve, a network of curves, a surface,
 * or points. At rest it is on or near the undeformed shape. Its points are called samples.
 */
struct BoundaryHandle
{
  Eigen::MatrixXd Positions; ///< s x 3, in the model's units
  Eigen::MatrixXi Segments;  ///< l x 2 indices of samples: the edges of the curves
  Eigen::MatrixXi Triangles; ///< m x 3 indices of samples: the surface's triangles
  Eigen::MatrixXd Normals;   ///< s x 3 normals of any length, or no rows
};

/// The new positions of a handle's samples, and the rotations of the shape there.
struct HandlePose
{
  Eigen::MatrixXd Positions;              ///< s x 3
  std::vector<Eigen::Matrix3d> Rotations; ///< s rotations R; a column vector x becomes R x
};

/// Builds a curve through positions (s x 3), in order. If `closed`, the last position is joined to
/// the first.
BoundaryHandle BuildCurveHandle(
  const Eigen::MatrixXd& positions, bool closed, const Eigen::MatrixXd& normals = {});

/// Builds closed curves through the points (n x 3) of each loop, in the order of the loops.
BoundaryHandle BuildLoopsHandle(
  const Eigen::MatrixXd& points, const std::vector<std::vector<int>>& loops);

/// Returns, for each sample, the index of the first sample at the same position, up to 1e-9 of the
/// diagonal of the handle's bounding box.
std::vector<int> GetFirstSamples(const BoundaryHandle& handle);

/// Returns, for each sample, the direction from the previous to the next sample (s x 3): the axis
/// about which equation 12 rotates frames. The direction is not normalised; it is 0 if the sample
/// is on no curve, or if more than two segments meet there.
Eigen::MatrixXd ComputeHandleTangents(
  const BoundaryHandle& handle, const Eigen::MatrixXd& positions);

/**
 * Computes the pose of a handle whose samples go to `positions` (s x 3) and whose normals become
 * `normals` (s x 3; no rows if the handle has none).
 *
 * With normals, each rotation takes a sample's frame (tangent and normal) to its new frame. The
 * tangents then agree exactly. Without normals, let P be the best rotation of the complete handle
 * (FitHandleRotation), and t the tangent at rest. The rotation is then P, followed by the minimum
 * rotation that takes P t to the new tangent. On surfaces, at branches of curves and at points
 * without a curve, the rotation is the best fit to the neighbours. It is P if the neighbours
 * determine no rotation. All of these rules are equivariant: if the handle moves rigidly, every
 * rotation equals the motion's rotation. The exception is a straight handle without normals, whose
 * twist is undetermined.
 *
 * Throws InvalidInput if sizes differ, a value is not finite, or only one of the handle and the
 * target has normals.
 */
HandlePose PoseHandle(const BoundaryHandle& handle, const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& normals = {});

/// Returns the rotation that fits the motion of the complete handle to `positions` best (Kabsch
/// 1976). Samples have weights by the share of the handle that they represent.
Eigen::Matrix3d FitHandleRotation(const BoundaryHandle& handle, const Eigen::MatrixXd& positions);

/// Returns the pose of the handle at rest.
HandlePose GetRestPose(const BoundaryHandle& handle);

/// Rotates each sample's frame by its angle about the tangent of the posed curve (M_i of equation
/// 12). angles: s values in radians, positive by the right-hand rule along the segments. Samples
/// without a tangent stay.
void RotateAboutTangents(
  const BoundaryHandle& handle, const Eigen::VectorXd& angles, HandlePose& pose);

} // namespace shape
