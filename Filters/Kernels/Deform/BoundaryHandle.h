#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * What a shape is deformed by: a curve, closed or open, a network of curves, a surface, or points,
 * at rest on (or near) the undeformed shape. Its points are called samples.
 */
struct BoundaryHandle
{
  Eigen::MatrixXd Positions; ///< s x 3, in the model's units
  Eigen::MatrixXi Segments;  ///< l x 2 samples: the curves
  Eigen::MatrixXi Triangles; ///< m x 3 samples: the surface
  Eigen::MatrixXd Normals;   ///< s x 3, of any length, or no rows
};

/// Where the samples of a handle go, and how the shape rotates there.
struct HandlePose
{
  Eigen::MatrixXd Positions;              ///< s x 3
  std::vector<Eigen::Matrix3d> Rotations; ///< s: x -> R x for columns x
};

/// A curve through positions (s x 3) in their order; if closed, back to the first one.
BoundaryHandle BuildCurveHandle(
  const Eigen::MatrixXd& positions, bool closed, const Eigen::MatrixXd& normals = {});

/// For each sample, the first one at the same position, within 1e-9 of the diagonal.
std::vector<int> GetFirstSamples(const BoundaryHandle& handle);

/// The direction from the sample before each one to the sample after it (s x 3): the axis that
/// equation 12 rotates frames about. Not normalised; 0 if a sample is on no curve, or if more than
/// two segments meet there.
Eigen::MatrixXd ComputeHandleTangents(
  const BoundaryHandle& handle, const Eigen::MatrixXd& positions);

/**
 * The pose of a handle whose samples go to `positions` (s x 3), where the shape's normals are to be
 * `normals` (s x 3; no rows if the handle has none).
 *
 * With normals, each rotation takes the frame of tangent and normal to the new one, exactly along
 * the tangent. Without, it is the rotation P of the handle as a whole (Kabsch 1976) followed by the
 * least rotation that takes P t to the new tangent. On surfaces, at branches of curves and at
 * points without a curve, it is the rotation that fits the neighbours best, P if they do not
 * determine one. All of these are equivariant: of a rigid motion, every rotation is that motion's,
 * except for a straight handle without normals, whose twist is undetermined.
 *
 * Throws InvalidInput if sizes differ, a value is not finite, or one of the handle and the target
 * has normals and the other has none.
 */
HandlePose PoseHandle(const BoundaryHandle& handle, const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& normals = {});

/// The handle at rest.
HandlePose GetRestPose(const BoundaryHandle& handle);

/// Rotates each sample's frame by an angle (s, radians) about the tangent of the posed curve, by
/// the right-hand rule along the segments: M_i of equation 12. Samples without a tangent stay.
void RotateAboutTangents(
  const BoundaryHandle& handle, const Eigen::VectorXd& angles, HandlePose& pose);

} // namespace shape
