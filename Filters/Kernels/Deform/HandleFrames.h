#pragma once

#include "Deform/BoundaryHandle.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <array>

namespace shape
{

struct PoseOptions
{
  std::array<double, 3> BiasFrame = { 0.0, 0.0, 1.0 }; ///< a direction, of any length except 0
  double BiasWeight = 0.0;                             ///< in [0, 1]; 0: no bias
};

/// Rotations that are prescribed at some samples of a handle.
struct PrescribedRotations
{
  Eigen::MatrixXd Turns; ///< s x 3: rotation vectors (axis times angle in radians), for x -> R x
  Eigen::VectorXi IsSet; ///< s: non-zero if the rotation is prescribed
};

/**
 * Applies prescribed rotations after those of a pose, interpolated between the samples. Along a
 * curve the interpolation is linear in the arc length of the handle at rest, and constant beyond
 * the last prescribed sample. At branches and on surfaces it is harmonic along edges. Components of
 * the handle without a prescribed rotation stay. Rotation vectors are averaged, which allows twists
 * of several turns.
 *
 * Throws InvalidInput if sizes differ or a prescribed rotation is not finite.
 */
void AddPrescribedRotations(
  const BoundaryHandle& handle, const PrescribedRotations& turns, HandlePose& pose);

/**
 * Rotates each frame to bring the shape's posed normal there closer to BiasFrame: by the share
 * BiasWeight of the minimum rotation between them (the bias frame F_B and alpha of section 2.2).
 * The rotation of the pose about that normal does not change.
 *
 * normals: s x 3, at rest (ComputeHandleNormals); samples with a zero normal stay. Throws
 * InvalidInput if an option is out of range.
 */
void BiasFrames(const BoundaryHandle& handle, const Eigen::MatrixXd& normals,
  const PoseOptions& options, HandlePose& pose);

/// Returns the normals of the shape at a handle (s x 3): those of the handle if it has any.
/// Otherwise they are those of the shape's triangles around the nearest node. If no triangle is
/// near, they are the normal of the plane that fits the handle best; if there is none, 0.
Eigen::MatrixXd ComputeHandleNormals(const BoundaryHandle& handle, const PointGraph& shape);

} // namespace shape
