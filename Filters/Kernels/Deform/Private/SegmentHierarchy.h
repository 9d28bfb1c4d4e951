#pragma once

#include "Deform/Private/MultiresolutionDeformation.h"
#include "Deform/Private/NodeDeformation.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Deformation segment by segment (section 2.3, Fig. 9). Each connected part with one label follows
 * the adjacent nodes that are moved by the handle or by earlier parts. Parts are ordered by the
 * time at which the front reaches them. Parts that meet on the front but are not adjacent on the
 * shape therefore move independently.
 */
class SegmentHierarchy : public NodeDeformation
{
public:
  /// labels: one for each node; the labels of sources are ignored. Throws the exceptions of
  /// `solve`, and Aborted.
  SegmentHierarchy(NodeProblem problem, const Eigen::VectorXi& labels, const NodeSolver& solve,
    const Progress& progress = {});

  NodeTransforms Move(
    const NodeTransforms& sources, double reach, const Progress& progress = {}) const override;

  int Segments() const { return static_cast<int>(this->Parts.size()); }

private:
  struct Part
  {
    std::vector<int> Nodes; ///< the sources of the part, then its other nodes
    int Sources;
    double Arrival; ///< time at which the front reaches the first of the other nodes
    std::unique_ptr<NodeDeformation> Solution;
  };

  std::vector<Part> Parts;
  std::vector<int> Sources;
  int Size;
};

} // namespace shape
