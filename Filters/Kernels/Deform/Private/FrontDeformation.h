#pragma once

#include "Deform/Private/BlendedRows.h"
#include "Deform/Private/NodeDeformation.h"

namespace shape
{

/**
 * Upwind-front deformation in full resolution: each node relative to those just before it on a
 * front that sweeps from the sources over the graph (equations 5 to 9).
 *
 * Bands are ranges of ranks (UpwindFront), so weights are dense rows of floats, kept up to
 * MaximumKeptWeights. The sums over them are in double precision: weights divided by their sum
 * keep rigid motions exact, however they are rounded.
 */
class FrontDeformation : public NodeDeformation
{
public:
  /// Throws InvalidInput if the graph is not connected, Aborted.
  explicit FrontDeformation(NodeProblem problem, const Progress& progress = {});

  NodeTransforms Move(
    const NodeTransforms& sources, double reach, const Progress& progress = {}) const override;

private:
  void KeepWeights(const Progress& progress);
  /// Blends the motions of the band of a rank. one, weights: memory for a row that is not kept.
  BlendedTransform Blend(
    int rank, const SampleTransforms& samples, BlendedRows& one, std::vector<float>& weights) const;

  NodeProblem Problem;
  FrontSweep Sweep;
  UpwindFront Front;
  BlendedRows Rows;
  Eigen::MatrixXd Rests; ///< 3 x n: the positions by rank, relative to the centre of the graph
};

} // namespace shape
