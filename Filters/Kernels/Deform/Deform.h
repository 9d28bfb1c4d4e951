#pragma once

#include "Base/Progress.h"
#include "Deform/BoundaryHandle.h"
#include "Deform/HandleFrames.h"
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

/// The target positions of a handle, with normals and rotations.
struct HandleTarget
{
  Eigen::MatrixXd Positions; ///< s x 3
  Eigen::MatrixXd Normals;   ///< s x 3 if the handle has normals, else no rows
  PrescribedRotations Turns; ///< prescribed rotations; no rows if there are none
};

/// Computes the pose of a handle at a target: frames by PoseHandle, then the prescribed rotations,
/// then the bias. graph: of the shape, from which missing normals of the handle are taken. Throws
/// InvalidInput.
HandlePose PoseHandleAt(const BoundaryHandle& handle, const HandleTarget& target,
  const PoseOptions& options, const PointGraph& graph);

/**
 * Deforms shapes, and reuses the weights as long as only the target or its frames change. Points
 * and elements are sorted first. So, except for rounding, the result does not depend on their order
 * or on their distribution over pieces.
 */
class Deformer
{
public:
  /// Deforms a shape. Throws InvalidInput (see BuildPointGraph, PrepareDeformation, PoseHandleAt),
  /// Aborted; the stored state remains valid.
  DeformedShape Deform(const DeformProblem& problem, const HandleTarget& target,
    const PoseOptions& options = {}, const Progress& progress = {});

  /// The facts of the last call, and whether it had to compute weights.
  const DeformFacts& Facts() const { return this->Deformation->Facts(); }
  bool HasPrepared() const { return this->Fresh; }
  ///@}

private:
  bool HasShape(const ShapeElements& shape) const;
  /// Returns whether everything except the shape is unchanged.
  bool Fits(const DeformProblem& problem) const;

  DeformProblem Problem;
  std::vector<int> Order; ///< of the points, by position
  PointGraph Graph;
  std::unique_ptr<ShapeDeformation> Deformation;
  bool Fresh = false;
};

} // namespace shape
