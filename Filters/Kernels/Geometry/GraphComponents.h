#pragma once

#include "Geometry/PointGraph.h"

#include <vector>

namespace shape
{

/**
 * Links each piece of a graph that no link joins to one of the nodes `mainland` to the nearest node
 * of another piece, until all are joined: the parts of a soup, loose points. Returns how many
 * pieces there were.
 *
 * mainland: at least one node. Throws Aborted.
 */
int ConnectComponents(
  PointGraph& graph, const std::vector<int>& mainland, const Progress& progress = {});

} // namespace shape
