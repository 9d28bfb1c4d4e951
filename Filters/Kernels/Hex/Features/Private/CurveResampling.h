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
  /// bends: the edges of a point that moves stay within the tolerance.
  std::vector<Eigen::MatrixXd> Spans;
};

/**
 * Distributes the points of a chain (n x 3, n >= 2) along a curve. A point at a certain fraction of
 * the chain's length is put at the same fraction of the curve's length. If there are enough points,
 * one is fixed at each sharp bend of the curve, and the points between fixed ones are adjusted.
 * Then points move to other bends near them where the edges of the chain come closer to the curve.
 * If some edges stay farther than the tolerance, points gather there, unless the chain has too few.
 * Edges whose ends coincide get a length. On a closed curve the chain may begin anywhere.
 *
 * tolerance: the distance between curve and chain that is small enough, > 0.
 */
CurvePositions DistributeAlongCurve(
  const Eigen::MatrixXd& chain, const Mesh& surface, const FeatureCurve& curve, double tolerance);

/// The distance between creases and chains that is small enough for most purposes: 0.08 % of the
/// diagonal of the surface's box, a little less than a grid's WantedCreaseDistance.
double ComputeCreaseTolerance(const Mesh& surface);

} // namespace shape
