#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * What a shape is deformed by: a curve, closed or open, a network of them, a surface, or points, at
 * their place on (or near) the undeformed shape. Its points are called samples.
 */
struct BoundaryHandle
{
  Eigen::MatrixXd Positions; ///< s x 3, in the model's units
  Eigen::MatrixXi Segments;  ///< l x 2 samples: the curves
  Eigen::MatrixXi Triangles; ///< m x 3 samples: the surface
  Eigen::MatrixXd Normals;   ///< s x 3, of any length, or no rows
};

/// Where the samples of a handle go, and how the shape turns there.
struct HandlePose
{
  Eigen::MatrixXd Positions;              ///< s x 3
  std::vector<Eigen::Matrix3d> Rotations; ///< s: columns turn, x -> R x
};

/// A curve through places (s x 3) in their order; closed, it goes back to the first one.
BoundaryHandle BuildCurveHandle(
  const Eigen::MatrixXd& positions, bool closed, const Eigen::MatrixXd& normals = {});

/// The sample itself, or the first one at its place, for each (within 1e-9 of the diagonal).
std::vector<int> GetFirstSamples(const BoundaryHandle& handle);

/// The direction from the sample before each one to the sample after it (s x 3): the axis that
/// equation 12 turns frames about. Not normalised; 0 where a sample is on no curve, or more than
/// two segments meet.
Eigen::MatrixXd ComputeHandleTangents(
  const BoundaryHandle& handle, const Eigen::MatrixXd& positions);

/**
 * The pose of a handle whose samples go to `places` (s x 3), where the shape's normals are to be
 * `normals` (s x 3; no rows where the handle has none).
 *
 * With normals, each rotation takes the frame of tangent and normal to the new one, exactly along
 * the tangent; without, it is the rotation P of the handle as a whole (Kabsch 1976) followed by the
 * least rotation that takes P t to the new tangent. On surfaces, where curves branch and where
 * points have no curve, it is the rotation that fits the neighbours best, P where they do not tell.
 * All of these turn exactly with the places: of a rigid motion, every rotation is that motion's,
 * unless a straight handle has no normals, whose twist nothing tells.
 *
 * Throws InvalidInput where sizes differ, a value is not finite, or one of the handle and the
 * target has normals and the other has none.
 */
HandlePose PoseHandle(const BoundaryHandle& handle, const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& normals = {});

/// The handle at its own place.
HandlePose GetRestPose(const BoundaryHandle& handle);

/// Turns each sample's rotation by an angle (s, radians) about the tangent of the posed curve, by
/// the right-hand rule along the segments: M_i of equation 12. Samples without a tangent stay.
void RotateAboutTangents(
  const BoundaryHandle& handle, const Eigen::VectorXd& angles, HandlePose& pose);

} // namespace shape
