#pragma once

#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The positions of a chain's points on a curve, and the part of it along which each may move.
struct CurvePositions
{
  Eigen::MatrixXd Positions; ///< n x 3
  /// n: the part of the curve around the position, as a polyline (k x 3). A point that could move
  /// along the whole curve would cut off its bends. One row if the point is fixed.
  std::vector<Eigen::MatrixXd> Spans;
};

/**
 * Distributes the points of a chain (n x 3, n >= 2) along a curve, at the same fractions of its
 * length. One point of the chain is fixed at each sharp bend of the curve, if there are enough
 * points. On a closed curve the chain may begin anywhere.
 */
CurvePositions DistributeAlongCurve(
  const Eigen::MatrixXd& chain, const Mesh& surface, const FeatureCurve& curve);

} // namespace shape
