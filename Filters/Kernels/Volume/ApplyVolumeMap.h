#pragma once

#include "Geometry/SignedDistance.h"
#include "Volume/ChargeSet.h"

namespace shape
{

struct MovedPoints
{
  Eigen::MatrixXd Points;        ///< n x 3
  Eigen::VectorXi OutsideDomain; ///< n: not 0 where a point keeps its place
};

/**
 * The values of a charge set's map at the points (n x 3, finite) of the domain that `boundary`
 * bounds: a closed, outward facing surface. Points outside keep their place and have OutsideDomain
 * 1; farthest: see OutsideDomain. For the way back see InverseMap.
 *
 * Throws SolveFailure where the map is not finite, Aborted.
 */
MovedPoints ApplyVolumeMap(const ChargeSet& map, const SignedDistance& boundary, double farthest,
  const Eigen::MatrixXd& points, const Progress& progress = {});

} // namespace shape
