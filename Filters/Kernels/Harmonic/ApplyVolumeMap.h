#pragma once

#include "Harmonic/PiecewiseHarmonicMap.h"

namespace shape
{

struct MovedPoints
{
  Eigen::MatrixXd Points;        ///< n x 3
  Eigen::VectorXi OutsideDomain; ///< n: not 0 where a point keeps its place
};

/**
 * The values of a volume map at the points (n x 3, finite) of its domain. Points outside keep their
 * place and have OutsideDomain 1: see the function of that name. For the way back see
 * PiecewiseInverseMap.
 *
 * Throws SolveFailure where the map is not finite, Aborted.
 */
MovedPoints ApplyVolumeMap(
  const PiecewiseHarmonicMap& map, const Eigen::MatrixXd& points, const Progress& progress = {});

} // namespace shape
