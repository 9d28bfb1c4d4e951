#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/SolidCells.h"

#include <Eigen/Core>

namespace shape
{

/// Returns positions of a solid's points (n x 3) such that each inner point is the mean of its
/// neighbours (W. T. Tutte, "How to draw a graph", 1963). Two points are neighbours if they share a
/// cell. Boundary points and points without a cell keep their positions.
Eigen::MatrixXd SolveTutteEmbedding(const SolidCells& solid, const Progress& progress);

/**
 * Returns the logarithm of the target size of the cells around each point. The size is the ratio of
 * a length to the same length at rest, or the length itself if there is no rest shape. At a
 * boundary point, the logarithm is the mean over the point's boundary edges. At an inner point, it
 * is the mean of the values at the neighbours, so inverted cells do not affect it.
 *
 * Returns one value for each point. Points that are not connected to a boundary get the mean of the
 * values at the boundary. Throws Aborted.
 */
Eigen::VectorXd ComputeLogarithmicSizes(const SolidCells& solid, const Progress& progress = {});

} // namespace shape
