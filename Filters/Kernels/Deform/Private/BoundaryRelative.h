#pragma once

#include "Deform/Private/BlendedRows.h"
#include "Deform/Private/NodeDeformation.h"

namespace shape
{

/**
 * Boundary-relative deformation: each node relative to the sources alone (equations 4 and 5). Far
 * from them, all sources count alike, and the shape is squashed: upwind-front deformation corrects
 * that.
 *
 * The weights are those of the sources over the power of the distance, which is Euclidean or along
 * the links of the graph; up to MaximumKeptWeights of them are kept.
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
  /// The distances of a rank from all sources.
  void FindDistances(int rank, double* distances) const;
  /// Returns whether a weight is not 0; else the nearest source has all the weight.
  bool FindRow(int rank, float* weights) const;

  NodeProblem Problem;
  FrontSweep Sweep;
  Eigen::MatrixXf Geodesics; ///< sources x ranks, or nothing
  BlendedRows Rows;
  Eigen::MatrixXd Rests; ///< 3 x n: the positions by rank, relative to the centre of the graph
};

} // namespace shape
