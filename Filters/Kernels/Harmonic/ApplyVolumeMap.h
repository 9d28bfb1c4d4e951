#pragma once

#include "Harmonic/FiniteElementMap.h"
#include "Harmonic/PiecewiseHarmonicMap.h"

namespace shape
{

struct MovedPoints
{
  Eigen::MatrixXd Points;        ///< n x 3
  Eigen::VectorXi OutsideDomain; ///< n: 1 if the point lies outside and is not moved, else 0
};

/**
 * Moves points (n x 3, finite) by a volume map. Points outside the map's domain
 * (FindPointsOutsideDomain) are not moved. For the inverse map, see PiecewiseInverseMap.
 *
 * Throws SolveFailure if the map is not finite at a point of its domain, and Aborted.
 */
MovedPoints ApplyVolumeMap(
  const PiecewiseHarmonicMap& map, const Eigen::MatrixXd& points, const Progress& progress = {});

/// The same by a map of finite elements. A point is outside if it is farther from the solid than
/// 1e-6 of its longest side. Throws Aborted.
MovedPoints ApplyVolumeMap(
  const FiniteElementMap& map, const Eigen::MatrixXd& points, const Progress& progress = {});

} // namespace shape
