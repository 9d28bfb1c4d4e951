#pragma once

#include "Deform/BoundaryHandle.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <array>

namespace shape
{

/// The bias of section 2.2: "We include a bias frame F_B, and a parameter alpha that controls
/// interpolation between the original frame and F_B."
struct PoseOptions
{
  std::array<double, 3> BiasFrame = { 0.0, 0.0, 1.0 }; ///< a direction, of any length except 0
  double BiasWeight = 0.0;                             ///< alpha, in [0, 1]; 0 means no bias
  enum class BiasByType
  {
    Direction, ///< F_B has the normal BiasFrame; the rotation about it is free
    Frame      ///< F_B is the frame of the undeformed shape, rotated by BiasRotation
  };
  BiasByType BiasBy = BiasByType::Direction;
  /// The axis, of which the length is the angle in degrees. No rotation: F_B is the frame at rest.
  std::array<double, 3> BiasRotation = { 0.0, 0.0, 0.0 };
};

/// Rotations that are prescribed at some samples of a handle.
struct PrescribedRotations
{
  Eigen::MatrixXd Turns; ///< s x 3 rotation vectors (axis times angle in radians) of x -> R x
  Eigen::VectorXi IsSet; ///< s values, non-zero where a rotation is prescribed
};

/**
 * Interpolates prescribed rotations between the samples at which they are prescribed. Along a
 * curve, the interpolation is linear in the arc length of the handle at rest, and constant beyond
 * the last prescribed sample. At branches and on surfaces it is harmonic along edges. Returns
 * rotation vectors (s x 3), which are 0 on components of the handle without a prescribed rotation.
 * Since rotation vectors are interpolated, twists of several turns are possible.
 *
 * Throws InvalidInput if sizes differ or a prescribed rotation is not finite.
 */
Eigen::MatrixXd InterpolateRotations(
  const BoundaryHandle& handle, const PrescribedRotations& turns);

/// Applies the interpolated rotations after the rotations of a pose. Throws InvalidInput when
/// InterpolateRotations does.
void AddPrescribedRotations(
  const BoundaryHandle& handle, const PrescribedRotations& turns, HandlePose& pose);

/// Throws InvalidInput if an option is out of range.
void RequireOptions(const PoseOptions& options);

/**
 * Rotates each frame towards the bias frame F_B, about one axis, by BiasWeight times the angle
 * between the two: along the geodesic of the rotations.
 *
 * Direction: F_B is the frame nearest to the posed frame of which the shape's normal points along
 * BiasFrame. The pose's rotation about that normal does not change. Samples with a zero normal
 * stay. Frame: all samples have the same F_B, which is the rotation `rest`, followed by
 * BiasRotation. With BiasWeight 1, every frame of the deformed shape is therefore F_B, and detail
 * has the same orientation everywhere. A frame half a turn from F_B has two geodesics, of which
 * either may be taken.
 *
 * normals: s x 3, the normals at rest (ComputeHandleNormals). rest: the rotation of the undeformed
 * shape. Throws InvalidInput if an option is out of range.
 */
void BiasFrames(const BoundaryHandle& handle, const Eigen::MatrixXd& normals,
  const PoseOptions& options, HandlePose& pose,
  const Eigen::Matrix3d& rest = Eigen::Matrix3d::Identity());

/// Returns the normals of the shape at a handle (s x 3). If the handle has normals, these are
/// returned. Otherwise, each sample's normal is that of the shape's triangles around the node
/// nearest to the sample. If that node is far away or has no triangle, the sample's normal is that
/// of the plane that fits the handle best, or 0 if there is no such plane.
Eigen::MatrixXd ComputeHandleNormals(const BoundaryHandle& handle, const PointGraph& shape);

} // namespace shape
