#pragma once

#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Where the points of a chain are put on a curve, and where each may go.
struct CurvePositions
{
  Eigen::MatrixXd Positions; ///< n x 3
  /// n: a part of the curve as a polyline (k x 3), some way before and behind the position: a point
  /// that could go anywhere on the curve would leave bends out. One row where the point is fixed.
  std::vector<Eigen::MatrixXd> Spans;
};

/**
 * Puts the points of a chain (n x 3, n >= 2) along a curve, at its share of the length where they
 * are at theirs of the chain's. Where the curve turns sharply a point of the chain is fixed, as far
 * as there are enough of them. A chain of a closed curve may begin anywhere.
 */
CurvePositions DistributeAlongCurve(
  const Eigen::MatrixXd& chain, const Mesh& surface, const FeatureCurve& curve);

} // namespace shape
