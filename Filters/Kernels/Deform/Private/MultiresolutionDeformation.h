#pragma once

#include "Deform/Private/CoarseShape.h"
#include "Deform/Private/NodeDeformation.h"

#include <functional>
#include <memory>
#include <vector>

namespace shape
{

/// How a problem is solved in full resolution.
using NodeSolver =
  std::function<std::unique_ptr<NodeDeformation>(NodeProblem problem, const Progress& progress)>;

/**
 * Multiresolution (section 2.3): a coarse, smooth base of the graph (BuildCoarseShape) is deformed
 * in full, and each node of the fine one relative to the base's nodes around the one that it was
 * merged into, nearest first, by equation 5.
 *
 * Those weights fall to 0 at the first base node that is left out, so that none comes or goes at
 * once, and are then tilted so that their mean place is the node's own, across the small detail
 * that the base lacks: what the base stretches evenly, the shape does, too. Sources are nodes of
 * the base and stay exact.
 */
class MultiresolutionDeformation : public NodeDeformation
{
public:
  /// baseNodes: wanted beside the sources. Throws what `solve` throws, Aborted.
  MultiresolutionDeformation(
    NodeProblem problem, int baseNodes, const NodeSolver& solve, const Progress& progress = {});

  NodeTransforms Move(
    const NodeTransforms& sources, double reach, const Progress& progress = {}) const override;

private:
  struct Nearby; ///< a base node, and how far it is
  void FindAround();
  std::vector<Nearby> FindNearby(int node, double full) const;
  void AddRow(int node, double full);

  NodeProblem Problem;
  CoarseShape Coarse;
  std::unique_ptr<NodeDeformation> Inner;
  FrontSweep Sweep;                     ///< of the fine graph
  std::vector<std::vector<int>> Around; ///< base nodes near each; while rows are found
  std::vector<char> IsSource;           ///< of base nodes
  std::vector<double> Reaches; ///< by rank: how far the base has to be deformed up to there
  std::vector<std::size_t> First;
  std::vector<int> Columns;   ///< base nodes, of each rank that is no source
  std::vector<float> Weights; ///< some perhaps negative
  std::vector<double> Sums;
};

} // namespace shape
