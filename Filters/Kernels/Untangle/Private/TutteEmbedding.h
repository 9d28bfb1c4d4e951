#pragma once

#include "Untangle/Private/SolidCells.h"

#include <Eigen/Core>

namespace shape
{

/// Returns positions (n x 3) of a solid's points at which each inner point is the mean of the
/// points it shares a cell with (W. T. Tutte, "How to draw a graph", 1963). Boundary points and
/// points without a cell keep their positions.
Eigen::MatrixXd SolveTutteEmbedding(const SolidCells& solid);

/**
 * Returns the wanted size of cells around each point: the logarithm of a length over the same
 * length at rest (over 1 without a rest shape). At the boundary it is the mean over the point's
 * edges. Inside it is harmonic (the mean of the neighbours), so inverted cells do not affect it.
 *
 * Returns one value for each point of `solid`; points not connected to a boundary get the mean.
 */
Eigen::VectorXd ComputeLogarithmicSizes(const SolidCells& solid);

} // namespace shape
