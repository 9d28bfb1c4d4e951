#pragma once

#include "Untangle/Private/SolidCells.h"

namespace shape
{

/// Positions (n x 3) of a solid's points where each point inside is the mean of those it shares a
/// cell with (W. T. Tutte, "How to draw a graph", 1963), and those of the boundary are where they
/// are. Points of no cell stay.
Eigen::MatrixXd SolveTutteEmbedding(const SolidCells& solid);

} // namespace shape
