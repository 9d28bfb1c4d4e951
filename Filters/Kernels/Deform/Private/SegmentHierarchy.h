#pragma once

#include "Deform/Private/MultiresolutionDeformation.h"
#include "Deform/Private/NodeDeformation.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Deformation segment by segment (section 2.3, Fig. 9): each connected part of one label follows
 * the adjacent nodes that the handle or earlier parts move. Parts come in the order in which the
 * front reaches them. So parts that meet on the front, but are not adjacent on the shape, move
 * independently.
 */
class SegmentHierarchy : public NodeDeformation
{
public:
  /// labels: of each node; those of sources are ignored. Throws what `solve` throws, Aborted.
  SegmentHierarchy(NodeProblem problem, const Eigen::VectorXi& labels, const NodeSolver& solve,
    const Progress& progress = {});

  NodeTransforms Move(
    const NodeTransforms& sources, double reach, const Progress& progress = {}) const override;

  int Segments() const { return static_cast<int>(this->Parts.size()); }

private:
  struct Part
  {
    std::vector<int> Nodes; ///< its sources, then its own
    int Sources;
    double Arrival; ///< of the first of its own
    std::unique_ptr<NodeDeformation> Solution;
  };

  std::vector<Part> Parts;
  std::vector<int> Sources;
  int Size;
};

} // namespace shape
