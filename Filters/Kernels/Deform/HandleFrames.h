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

/// Turns that were set at some samples of a handle.
struct PrescribedRotations
{
  Eigen::MatrixXd Turns; ///< s x 3: rotation vectors (axis times angle in radians), as x -> R x
  Eigen::VectorXi IsSet; ///< s: not 0 where the turn counts
};

/**
 * Turns the rotations of a pose further by turns that were set at some samples, in between
 * interpolated: along a curve linearly in the arc length of the handle at rest, and as those of the
 * last set sample beyond it; where curves branch, and on surfaces, harmonically along edges. Pieces
 * of the handle without a set sample stay. The mean of turns of more than half a turn is one, too:
 * a twist by several turns is possible.
 *
 * Throws InvalidInput where sizes differ or a turn that is set is not finite.
 */
void AddPrescribedRotations(
  const BoundaryHandle& handle, const PrescribedRotations& turns, HandlePose& pose);

/**
 * Turns each rotation so that the shape's posed normal there comes nearer to BiasFrame: along the
 * least rotation that would take it there, by the share BiasWeight of its angle (the bias frame F_B
 * and alpha of section 2.2). What the handle's pose is otherwise, about that normal, stays.
 *
 * normals: s x 3, at rest (ComputeHandleNormals); samples where it is 0 stay. Throws InvalidInput
 * where an option is out of its range.
 */
void BiasFrames(const BoundaryHandle& handle, const Eigen::MatrixXd& normals,
  const PoseOptions& options, HandlePose& pose);

/// Normals of the shape at a handle (s x 3): the handle's own, else those of the shape's triangles
/// around the nearest node, else that of the plane that the handle fits best, else 0.
Eigen::MatrixXd ComputeHandleNormals(const BoundaryHandle& handle, const PointGraph& shape);

} // namespace shape
