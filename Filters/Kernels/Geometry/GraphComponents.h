#pragma once

#include "Geometry/PointGraph.h"

#include <vector>

namespace shape
{

/**
 * Connects a graph. Each component that contains none of the nodes in `mainland`, such as a part of
 * a soup or a loose point, is linked to the nearest node of another component, until all are
 * connected. Returns the original number of components.
 *
 * mainland: at least one node. Throws Aborted.
 */
int ConnectComponents(
  PointGraph& graph, const std::vector<int>& mainland, const Progress& progress = {});

} // namespace shape
