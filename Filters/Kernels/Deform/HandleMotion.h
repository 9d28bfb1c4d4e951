#pragma once

#include "Deform/BoundaryHandle.h"
#include "Deform/HandleFrames.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Throws InvalidInput if a sample of the handle is off the shape: farther from all of its points
/// than the longest edge of its elements.
void RequireOnShape(const BoundaryHandle& handle, const ShapeElements& shape);

/// The connected parts of a handle. Samples that belong to no segment and no triangle form one
/// part, which comes last.
struct HandleParts
{
  /// s values from 0 to Count - 1. Part 0 has the greatest total length of edges. Parts of equal
  /// length are ordered by their first samples.
  std::vector<int> PartOf;
  int Count = 0;
};

HandleParts FindHandleParts(const BoundaryHandle& handle);

/// Returns the centre of one part of a handle whose samples are at `positions` (s x 3): the
/// midpoints of its segments, weighted by their lengths, so that dense samples get no more weight.
/// Of a part without segments, it is the mean of the samples.
Eigen::Vector3d ComputePartCentre(const BoundaryHandle& handle, const HandleParts& parts, int part,
  const Eigen::MatrixXd& positions);

/// A similarity of one part of a handle about its centre c: x becomes c + Translation + Scale R (x
/// - c).
struct PartMotion
{
  int Part = 0;
  Eigen::Vector3d Translation = Eigen::Vector3d::Zero(); ///< in the model's units
  Eigen::Vector3d Rotation = Eigen::Vector3d::Zero();    ///< axis times angle in radians
  double Scale = 1.0;                                    ///< > 0
};

/// A rotation of the shape's frame at the sample of a handle that is closest to Position at rest.
struct FrameRotation
{
  Eigen::Vector3d Position = Eigen::Vector3d::Zero();
  Eigen::Vector3d Rotation = Eigen::Vector3d::Zero(); ///< axis times angle in radians
};

/// What the user does to a handle: first rotates frames, then moves parts with their frames.
struct HandleMotion
{
  std::vector<PartMotion> Parts; ///< motions of one part follow one another
  std::vector<FrameRotation> Frames;
};

/// Assigns each frame to the closest sample. If several frames have the same sample, the last one
/// counts. Throws InvalidInput if a number is not finite.
PrescribedRotations PrescribeRotations(
  const BoundaryHandle& handle, const std::vector<FrameRotation>& frames);

/// Moves parts of a posed handle: positions by the similarity, frames by its rotation. A motion
/// without translation, rotation and scale changes no bit. Throws InvalidInput if there is no such
/// part, a number is not finite, or a scale is not positive.
void MoveParts(
  const BoundaryHandle& handle, const std::vector<PartMotion>& motions, HandlePose& pose);

} // namespace shape
