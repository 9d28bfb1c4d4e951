#pragma once

#include "Base/Progress.h"
#include "Deform/BoundaryHandle.h"
#include "Deform/HandleFrames.h"
#include "Deform/HandleMotion.h"
#include "Deform/ShapeDeformation.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shape
{

/// A shape, its handle and the options: everything that the weights depend on.
struct DeformProblem
{
  ShapeElements Shape;
  BoundaryHandle Handle; ///< the weights do not depend on its normals
  DeformFields Fields;
  DeformOptions Options;
};

/// The target positions of a handle, with normals and rotations, and the motion from there.
struct HandleTarget
{
  Eigen::MatrixXd Positions; ///< s x 3
  Eigen::MatrixXd Normals;   ///< s x 3 if the handle has normals, else no rows
  PrescribedRotations Turns; ///< no rows if no rotations are prescribed
  HandleMotion Motion;
};

/// Computes the pose of a handle at a target: first PoseHandle, then AddPrescribedRotations, first
/// those of the target, then those of its motion, then MoveParts and BiasFrames. A rigid motion of
/// the entire handle therefore moves the deformed shape rigidly, whatever its frames are. normals:
/// s x 3, the normals at rest (ComputeHandleNormals). Throws InvalidInput when one of these
/// functions does.
HandlePose PoseHandleAt(const BoundaryHandle& handle, const HandleTarget& target,
  const PoseOptions& options, const Eigen::MatrixXd& normals);

/**
 * Deforms shapes, and reuses the weights as long as only the target or its frames change. Points
 * and elements are sorted first. Their order and their distribution over pieces therefore change
 * the result by rounding only.
 */
class Deformer
{
public:
  /// Deforms a shape, with the arrival times of its points. Throws InvalidInput when
  /// BuildPointGraph, PrepareDeformation or PoseHandleAt does; Aborted. The stored state then
  /// remains valid.
  DeformedShape Deform(const DeformProblem& problem, const HandleTarget& target,
    const PoseOptions& options = {}, const Progress& progress = {});

  /// Facts about the deformation of the last call, and whether this call had to compute weights.
  const DeformFacts& Facts() const { return this->Deformation->Facts(); }
  bool HasPrepared() const { return this->Fresh; }

  ///@{
  /// The handle of the last call: its pose, and the normals of the shape there, at rest (s x 3).
  const HandlePose& Pose() const { return this->LastPose; }
  const Eigen::MatrixXd& Normals() const { return this->LastNormals; }
  ///@}

private:
  bool HasShape(const ShapeElements& shape) const;
  /// Returns whether everything except the shape is unchanged.
  bool Fits(const DeformProblem& problem) const;

  DeformProblem Problem;
  std::vector<int> Order; ///< the points' indices, sorted by position
  PointGraph Graph;
  std::unique_ptr<ShapeDeformation> Deformation;
  bool Fresh = false;
  Eigen::MatrixXd ShapeNormals; ///< at the handle, if it has none
  Eigen::MatrixXd LastNormals;
  HandlePose LastPose;
};

} // namespace shape
