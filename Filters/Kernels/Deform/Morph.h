#pragma once

#include "Base/Progress.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shape
{

/// Returns the positions in a shape and in its targets (each n x 3) side by side, n x 3 (k + 1).
/// Points with the same row coincide in the shape and in every target.
Eigen::MatrixXd JoinPositions(
  const Eigen::MatrixXd& points, const std::vector<Eigen::MatrixXd>& targets);

/**
 * Moves a shape towards targets with the same elements, as rigidly as possible: parts that only
 * rotate keep their lengths on the way (Alexa, Cohen-Or and Levin, "As-rigid-as-possible shape
 * interpolation", 2000).
 *
 * Each element goes to its place in a target by a rotation after a stretch. Rotation vectors and
 * stretches are blended linearly. The positions fit the edges by weighted least squares, with one
 * factorisation for all weights. Of the vectors of a rotation, the nearest to that of a neighbour
 * is used, so that a part may rotate by several turns (Gao, Lai, Yang, Ling and Xia, "Sparse data
 * driven mesh deformation", 2019, section 3.1). The mean of the points of each connected component
 * moves in a straight line, as do points without elements. Points that coincide in the shape and in
 * every target move as one.
 */
class RigidMorph
{
public:
  /// targets: at least one, each n x 3, the new positions of the points of the shape. Throws
  /// InvalidInput if there is no target, one has another number of points, or a position is not
  /// finite; SolveFailure; Aborted.
  RigidMorph(const ShapeElements& shape, const std::vector<Eigen::MatrixXd>& targets,
    const Progress& progress = {});
  ~RigidMorph();
  RigidMorph(RigidMorph&&) noexcept;
  RigidMorph& operator=(RigidMorph&&) noexcept;

  /// Returns the positions (n x 3) for one weight per target. The weights 0 give the shape. The
  /// weight 1 of one target alone gives that target, up to rounding. Throws InvalidInput if the
  /// number of weights is wrong or one is not finite; Aborted.
  Eigen::MatrixXd At(const std::vector<double>& weights, const Progress& progress = {}) const;

private:
  struct Prepared;
  std::unique_ptr<Prepared> Impl;
};

} // namespace shape
