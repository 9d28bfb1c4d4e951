#pragma once

#include "Base/Progress.h"
#include "Geometry/PointGraph.h"

#include <vector>

namespace shape
{

/// A coarse, smooth shape, and the nodes of it that those of the fine one were merged into.
struct CoarseShape
{
  PointGraph Graph;         ///< Positions, links, Weights (sums of the merged ones) and MeanLength
  std::vector<int> Sources; ///< the nodes of the kept ones, in their order
  std::vector<int> BaseOf;  ///< of each fine node, the node that it was merged into
};

/**
 * The smooth base of a shape of any kind (section 2.3 of Schmidt and Singh, "Drag-and-drop surface
 * composition"): rounds of edge collapses, the shortest links first and no two adjacent, each
 * followed by smoothing without shrinkage (Taubin, "A signal processing approach to fair surface
 * design", 1995). Links are collapsed, not triangles: so soups and solids have a base, too.
 *
 * kept: different nodes, which keep their positions and are not merged with each other. count: of
 * the wanted nodes beside them; more are left if no link can be collapsed. Throws Aborted.
 */
CoarseShape BuildCoarseShape(
  const PointGraph& graph, const std::vector<int>& kept, int count, const Progress& progress = {});

} // namespace shape
