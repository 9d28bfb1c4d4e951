#pragma once

#include "Deform/Private/BlendedRows.h"
#include "Deform/Private/NodeDeformation.h"

namespace shape
{

/**
 * Upwind-front deformation in full resolution. A front sweeps over the graph from the sources. Each
 * node is moved relative to the nodes that the front reached just before it (equations 5 to 9).
 *
 * Bands are ranges of ranks (UpwindFront), so weights are dense rows of floats. Up to
 * MaximumKeptWeights weights are stored. Sums over rows are in double precision. Since weights are
 * divided by their sum, rigid motions stay exact however the weights are rounded.
 */
class FrontDeformation : public NodeDeformation
{
public:
  /// Throws InvalidInput if the graph is not connected; Aborted.
  explicit FrontDeformation(NodeProblem problem, const Progress& progress = {});

  NodeTransforms Move(
    const NodeTransforms& sources, double reach, const Progress& progress = {}) const override;

private:
  void KeepWeights(const Progress& progress);
  /// Blends the motions of the nodes in a rank's band. one, weights: memory for a row that is not
  /// stored.
  BlendedTransform Blend(
    int rank, const SampleTransforms& samples, BlendedRows& one, std::vector<float>& weights) const;

  NodeProblem Problem;
  FrontSweep Sweep;
  UpwindFront Front;
  BlendedRows Rows;
  Eigen::MatrixXd Rests; ///< 3 x n: the positions by rank, relative to the centre of the graph
};

} // namespace shape
