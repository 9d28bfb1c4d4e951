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

/// The target of a handle.
struct HandleTarget
{
  Eigen::MatrixXd Positions; ///< s x 3
  Eigen::MatrixXd Normals;   ///< s x 3 if the handle has normals, else no rows
  PrescribedRotations Turns; ///< no rows if none are set
};

/// The pose of a handle at a target: frames by PoseHandle, then the prescribed rotations, then the
/// bias. graph: of the shape, for normals that the handle lacks. Throws InvalidInput.
HandlePose PoseHandleAt(const BoundaryHandle& handle, const HandleTarget& target,
  const PoseOptions& options, const PointGraph& graph);

/**
 * Deforms shapes, and keeps the weights while only the target or the frames there change. Points
 * and elements are sorted first: so the result does not depend on their order, or on their
 * distribution over pieces, except for rounding.
 */
class Deformer
{
public:
  /// Throws InvalidInput (see BuildPointGraph, PrepareDeformation, PoseHandleAt), Aborted; what it
  /// keeps stays consistent.
  DeformedShape Deform(const DeformProblem& problem, const HandleTarget& target,
    const PoseOptions& options = {}, const Progress& progress = {});

  ///@{
  /// Of the last call: its facts, and whether it had to compute weights.
  const DeformFacts& Facts() const { return this->Deformation->Facts(); }
  bool HasPrepared() const { return this->Fresh; }
  ///@}

private:
  bool HasShape(const ShapeElements& shape) const;
  /// Whether everything except the shape is the same.
  bool Fits(const DeformProblem& problem) const;

  DeformProblem Problem;
  std::vector<int> Order; ///< of the points, by position
  PointGraph Graph;
  std::unique_ptr<ShapeDeformation> Deformation;
  bool Fresh = false;
};

} // namespace shape
