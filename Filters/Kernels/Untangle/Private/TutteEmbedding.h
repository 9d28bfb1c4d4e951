#pragma once

#include "Untangle/Private/SolidCells.h"

#include <Eigen/Core>

namespace shape
{

/// Positions (n x 3) of a solid's points where each point inside is the mean of those it shares a
/// cell with (W. T. Tutte, "How to draw a graph", 1963), and those of the boundary are where they
/// are. Points of no cell stay.
Eigen::MatrixXd SolveTutteEmbedding(const SolidCells& solid);

/**
 * How large cells should be around each point, as the logarithm of a length over the same length at
 * rest (or over 1 without one): at the boundary the mean over its edges, and inside as smooth as
 * can be (the mean of the neighbours), so that inverted cells have no say in it.
 *
 * Returns one value for each point of `solid`; points without a boundary in reach get the mean.
 */
Eigen::VectorXd ComputeLogarithmicSizes(const SolidCells& solid);

} // namespace shape
