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

/// What is deformed, by what, and how: all that weights depend on.
struct DeformProblem
{
  ShapeElements Shape;
  BoundaryHandle Handle; ///< its normals do not change the weights
  DeformFields Fields;
  DeformOptions Options;
};

/// Where a handle goes.
struct HandleTarget
{
  Eigen::MatrixXd Positions; ///< s x 3
  Eigen::MatrixXd Normals;   ///< s x 3 where the handle has normals, else no rows
  PrescribedRotations Turns; ///< no rows where none are set
};

/// The pose of a handle at a target: frames by PoseHandle, with turns that were set and a bias.
/// graph: of the shape, for normals that the handle lacks. Throws InvalidInput.
HandlePose PoseHandleAt(const BoundaryHandle& handle, const HandleTarget& target,
  const PoseOptions& options, const PointGraph& graph);

/**
 * Deforms shapes, and keeps what it prepared while nothing but the target, or the frames there,
 * changes. Points and elements are sorted first: what comes out does not depend on their order, or
 * on the pieces that they came in, but for rounding.
 */
class Deformer
{
public:
  /// Throws InvalidInput (see BuildPointGraph, PrepareDeformation, PoseHandleAt), Aborted; what it
  /// keeps is whole all the same.
  DeformedShape Deform(const DeformProblem& problem, const HandleTarget& target,
    const PoseOptions& options = {}, const Progress& progress = {});

  ///@{
  /// Of the last call: what was met, and whether it had to prepare.
  const DeformFacts& Facts() const { return this->Deformation->Facts(); }
  bool HasPrepared() const { return this->Fresh; }
  ///@}

private:
  bool HasShape(const ShapeElements& shape) const;
  /// But for the shape.
  bool Fits(const DeformProblem& problem) const;

  DeformProblem Problem;
  std::vector<int> Order; ///< of the points, by place
  PointGraph Graph;
  std::unique_ptr<ShapeDeformation> Deformation;
  bool Fresh = false;
};

} // namespace shape
