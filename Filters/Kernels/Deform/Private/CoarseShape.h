#pragma once

#include "Base/Progress.h"
#include "Geometry/PointGraph.h"

#include <vector>

namespace shape
{

/// A coarse, smooth shape, and the map from the nodes of the fine shape to those of the coarse one.
struct CoarseShape
{
  PointGraph Graph;         ///< Positions, links, Weights (sums over merged nodes) and MeanLength
  std::vector<int> Sources; ///< the coarse nodes of `kept`, in their order
  std::vector<int> BaseOf;  ///< for each fine node, the node into which it was merged
};

/**
 * Builds the smooth base of a shape of any kind (section 2.3 of Schmidt and Singh, "Drag-and-drop
 * surface composition"). Rounds of edge collapses alternate with smoothing without shrinkage
 * (Taubin, "A signal processing approach to fair surface design", 1995). In each round, the
 * shortest links are collapsed first, but never two adjacent links. Since links are collapsed
 * instead of triangles, soups and solids also have a base.
 *
 * kept: distinct nodes, which keep their positions and are not merged with each other. count: the
 * wanted number of other nodes; more are left if no further link can be collapsed. Throws Aborted.
 */
CoarseShape BuildCoarseShape(
  const PointGraph& graph, const std::vector<int>& kept, int count, const Progress& progress = {});

} // namespace shape
