#pragma once

#include "Skeleton/CurveSkeleton.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// Number of radii that describe a branch.
constexpr int RadiusSamples = 9;

/// A branch as it is compared with others. Lengths are shares of the skeleton's length.
struct GraphBranch
{
  enum class Kind
  {
    Point, ///< one point, without links
    Cycle, ///< closed, without a junction
    Open   ///< from one node to another, or back to the same junction
  };
  Kind Type = Kind::Open;
  int Number = 0;                          ///< the branch of the skeleton
  std::array<int, 2> Nodes = { -1, -1 };   ///< at its begin and end
  double Length = 0.0;                     ///< with the radii at both ends
  std::array<double, RadiusSamples> Radii; ///< at equal distances from begin to end
};

/// The place where branches meet or end. Side 2 b + e is the begin (e = 0) or end (1) of branch b.
struct GraphNode
{
  std::vector<int> Sides;
};

/// A skeleton whose close junctions are one.
struct BranchGraph
{
  std::vector<GraphBranch> Branches;
  std::vector<GraphNode> Nodes;
  Eigen::MatrixXd Directions; ///< for each side, the unit vector from its node along the branch
  std::vector<int> NodeOf;    ///< for each point of the skeleton, its node, or -1
};

/// Returns the lengths from the begin of a branch to each of its points.
Eigen::VectorXd MeasureAlong(const CurveSkeleton& skeleton, const std::vector<int>& branch);

/// Makes the graph of a skeleton. Junctions are merged if the branch between them is shorter than
/// `overlap` times the sum of their radii (1: their balls overlap), the shortest branches first,
/// unless the branch closes a cycle.
BranchGraph MakeBranchGraph(const CurveSkeleton& skeleton, double overlap = 1.0);

} // namespace shape
