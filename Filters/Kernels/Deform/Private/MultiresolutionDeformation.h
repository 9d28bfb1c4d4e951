#pragma once

#include "Deform/Private/CoarseShape.h"
#include "Deform/Private/NodeDeformation.h"

#include <functional>
#include <memory>
#include <vector>

namespace shape
{

/// The solver in full resolution.
using NodeSolver =
  std::function<std::unique_ptr<NodeDeformation>(NodeProblem problem, const Progress& progress)>;

/**
 * Multiresolution (section 2.3): a coarse, smooth base of the graph (BuildCoarseShape) is deformed
 * first. Then each node of the fine graph is moved by equation 5, relative to the base nodes
 * nearest to the base node into which it was merged.
 *
 * The weights decrease to 0 at the first base node that is left out, which makes them continuous.
 * Then the weights are tilted tangentially to the base, so that the weighted mean of the base
 * nodes' positions is as near to the node as positive weights allow. The shape therefore stretches
 * evenly where the base does. Sources are also nodes of the base, so they follow the handle
 * exactly.
 */
class MultiresolutionDeformation : public NodeDeformation
{
public:
  /// baseNodes: the wanted number of base nodes, not counting the sources. Throws the exceptions of
  /// `solve`, and Aborted.
  MultiresolutionDeformation(
    NodeProblem problem, int baseNodes, const NodeSolver& solve, const Progress& progress = {});

  NodeTransforms Move(
    const NodeTransforms& sources, double reach, const Progress& progress = {}) const override;

private:
  struct Nearby; ///< a base node and its distance
  void FindAround();
  std::vector<Nearby> FindNearby(int node, double full) const;
  void AddRow(int node, double full);

  NodeProblem Problem;
  CoarseShape Coarse;
  std::unique_ptr<NodeDeformation> Inner;
  FrontSweep Sweep; ///< the sweep over the fine graph
  /// Base nodes near each base node; stored only while rows are computed.
  std::vector<std::vector<int>> Around;
  std::vector<char> IsSource;  ///< for each base node
  std::vector<double> Reaches; ///< by rank: the reach in the base that is needed up to that rank
  std::vector<std::size_t> First;
  std::vector<int> Columns;   ///< base nodes for each rank that is not a source
  std::vector<float> Weights; ///< positive; the largest of a row is 1
  std::vector<double> Sums;
};

} // namespace shape
