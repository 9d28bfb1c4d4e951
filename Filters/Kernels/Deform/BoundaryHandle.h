#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The handle by which a shape is deformed: a curve, closed or open, a network of curves, a surface,
 * or points. At rest it is on or near the undeformed shape. Its points are called samples.
 */
struct BoundaryHandle
{
  Eigen::MatrixXd Positions; ///< s x 3, in the model's units
  Eigen::MatrixXi Segments;  ///< l x 2 indices of samples: the curves
  Eigen::MatrixXi Triangles; ///< m x 3 indices of samples: the surface
  Eigen::MatrixXd Normals;   ///< s x 3, of any length, or no rows
};

/// The new positions of a handle's samples, and the rotations of the shape there.
struct HandlePose
{
  Eigen::MatrixXd Positions;              ///< s x 3
  std::vector<Eigen::Matrix3d> Rotations; ///< s: x -> R x for columns x
};

/// Builds a curve through positions (s x 3) in their order; if closed, it returns to the first one.
BoundaryHandle BuildCurveHandle(
  const Eigen::MatrixXd& positions, bool closed, const Eigen::MatrixXd& normals = {});

/// Returns, for each sample, the first one at the same position, within 1e-9 of the diagonal.
std::vector<int> GetFirstSamples(const BoundaryHandle& handle);

/// Returns the direction from the previous to the next sample for each sample (s x 3): the axis
/// about which equation 12 rotates frames. Not normalised; 0 if a sample is on no curve, or if more
/// than two segments meet there.
Eigen::MatrixXd ComputeHandleTangents(
  const BoundaryHandle& handle, const Eigen::MatrixXd& positions);

/**
 * Computes the pose of a handle whose samples go to `positions` (s x 3) and whose normals become
 * `normals` (s x 3; no rows if the handle has none).
 *
 * With normals, each rotation takes the frame of tangent and normal to the new one, exactly along
 * the tangent. Without normals, it is the best rotation P of the complete handle (Kabsch 1976),
 * followed by the minimum rotation that takes P t to the new tangent. On surfaces, at branches of
 * curves and at points without a curve, it is the rotation that fits the neighbours best, or P if
 * they do not determine one. All of these are equivariant: if the motion is rigid, every rotation
 * is the one of the motion. The exception is a straight handle without normals, whose twist is
 * undetermined.
 *
 * Throws InvalidInput if sizes differ, a value is not finite, or only one of the handle and the
 * target has normals.
 */
HandlePose PoseHandle(const BoundaryHandle& handle, const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& normals = {});

/// Returns the pose of the handle at rest.
HandlePose GetRestPose(const BoundaryHandle& handle);

/// Rotates each sample's frame by an angle (s, radians) about the tangent of the posed curve, by
/// the right-hand rule along the segments: M_i of equation 12. Samples without a tangent stay.
void RotateAboutTangents(
  const BoundaryHandle& handle, const Eigen::VectorXd& angles, HandlePose& pose);

} // namespace shape
