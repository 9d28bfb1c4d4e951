#pragma once

#include "Deform/Private/BlendedRows.h"
#include "Deform/Private/NodeDeformation.h"

namespace shape
{

/**
 * Boundary-relative deformation: each node is moved relative to the sources alone (equations 4 and
 * 5). Far from the sources, all of them have nearly equal weights, which squashes the shape.
 * Upwind-front deformation avoids this.
 *
 * The weight of a source is divided by a power of its distance from the node. This distance is
 * Euclidean or along the links of the graph. Up to MaximumKeptWeights weights are stored.
 */
class BoundaryRelative : public NodeDeformation
{
public:
  /// Throws InvalidInput if the graph is not connected, or if there are more geodesic distances
  /// than MaximumKeptWeights; Aborted.
  explicit BoundaryRelative(NodeProblem problem, const Progress& progress = {});

  NodeTransforms Move(
    const NodeTransforms& sources, double reach, const Progress& progress = {}) const override;

private:
  /// Computes the distances of a rank's node from all sources.
  void FindDistances(int rank, double* distances) const;
  /// Computes the weights of a rank. If all weights would be 0, gives weight 1 to the nearest
  /// source, and returns false.
  bool FindRow(int rank, float* weights) const;

  NodeProblem Problem;
  FrontSweep Sweep;
  Eigen::MatrixXf Geodesics; ///< sources x ranks, or empty
  BlendedRows Rows;
  Eigen::MatrixXd Rests; ///< 3 x n: the positions by rank, relative to the centre of the graph
};

} // namespace shape
