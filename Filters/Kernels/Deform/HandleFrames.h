#pragma once

#include "Deform/BoundaryHandle.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <array>

namespace shape
{

struct PoseOptions
{
  std::array<double, 3> BiasFrame = { 0.0, 0.0, 1.0 }; ///< a direction, of any length but 0
  double BiasWeight = 0.0;                             ///< in [0, 1]; 0: none
};

/// Rotations that are prescribed at some samples of a handle.
struct PrescribedRotations
{
  Eigen::MatrixXd Turns; ///< s x 3: rotation vectors (axis times angle in radians), as x -> R x
  Eigen::VectorXi IsSet; ///< s: not 0 if the rotation is prescribed
};

/**
 * Applies prescribed rotations after those of a pose. They are interpolated between the samples:
 * linearly in the arc length of the handle at rest along a curve, and constant beyond the last
 * prescribed sample; harmonically along edges at branches and on surfaces. Components of the handle
 * without a prescribed rotation stay. Rotation vectors are averaged, so that a twist by several
 * turns is possible.
 *
 * Throws InvalidInput if sizes differ or a prescribed rotation is not finite.
 */
void AddPrescribedRotations(
  const BoundaryHandle& handle, const PrescribedRotations& turns, HandlePose& pose);

/**
 * Rotates each frame so that the shape's posed normal there comes nearer to BiasFrame: by the share
 * BiasWeight of the least rotation that takes it there (the bias frame F_B and alpha of section
 * 2.2). The rotation of the pose about that normal stays.
 *
 * normals: s x 3, at rest (ComputeHandleNormals); samples whose normal is 0 stay. Throws
 * InvalidInput if an option is out of range.
 */
void BiasFrames(const BoundaryHandle& handle, const Eigen::MatrixXd& normals,
  const PoseOptions& options, HandlePose& pose);

/// The normals of the shape at a handle (s x 3): the handle's own; else of the shape's triangles
/// around the nearest node; else of the plane that fits the handle best; else 0.
Eigen::MatrixXd ComputeHandleNormals(const BoundaryHandle& handle, const PointGraph& shape);

} // namespace shape
