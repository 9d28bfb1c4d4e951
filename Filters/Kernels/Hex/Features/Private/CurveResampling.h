#pragma once

#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The positions of a chain's points on a curve, and for each point the part of the curve along
/// which it may move.
struct CurvePositions
{
  Eigen::MatrixXd Positions; ///< n x 3
  /// For each of the n points: the part of the curve around its position, as a polyline (k x 3), or
  /// one row if the point is fixed. Points that could move along the whole curve would cut off its
  /// bends: where the curve bends, the part is shorter than half a step of the chain to each side.
  std::vector<Eigen::MatrixXd> Spans;
};

/**
 * Distributes the points of a chain (n x 3, n >= 2) along a curve. A point at a certain fraction of
 * the chain's length is put at the same fraction of the curve's length. If there are enough points,
 * one is fixed at each sharp bend of the curve, and the points between fixed ones are adjusted. On
 * a closed curve the chain may begin anywhere.
 */
CurvePositions DistributeAlongCurve(
  const Eigen::MatrixXd& chain, const Mesh& surface, const FeatureCurve& curve);

} // namespace shape
