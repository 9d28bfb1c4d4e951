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
 * in full, and each node of the fine graph relative to the nearest base nodes around the one that
 * it was merged into, by equation 5.
 *
 * These weights decrease to 0 at the first base node that is left out, so that they are continuous.
 * Then they are tilted so that their mean position is the node's own, tangentially to the base: so
 * the shape stretches evenly where the base does. Sources are nodes of the base and stay exact.
 */
class MultiresolutionDeformation : public NodeDeformation
{
public:
  /// baseNodes: their wanted number without the sources. Throws what `solve` throws, Aborted.
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
  FrontSweep Sweep;                     ///< of the fine graph
  std::vector<std::vector<int>> Around; ///< base nodes near each; while rows are found
  std::vector<char> IsSource;           ///< of base nodes
  std::vector<double> Reaches; ///< by rank: the reach in the base that is needed up to there
  std::vector<std::size_t> First;
  std::vector<int> Columns;   ///< base nodes, of each rank that is no source
  std::vector<float> Weights; ///< some may be negative
  std::vector<double> Sums;
};

} // namespace shape
