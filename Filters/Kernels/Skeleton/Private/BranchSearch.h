#pragma once

#include "Base/Progress.h"
#include "Skeleton/Private/BranchGraph.h"

#include <vector>

namespace shape
{

/// An isomorphism of two graphs: Sides[i] is the side of the target of side i.
struct GraphMatch
{
  std::vector<int> Sides;
  double Difference = 0.0;
};

struct GraphMatches
{
  std::vector<GraphMatch> Found; ///< the best first; all those within the tolerance, or the first
  bool Complete = true;          ///< whether all were compared
};

/// The difference between branch `a` and branch `b`, from its begin or from its end.
double CompareBranches(const GraphBranch& a, const GraphBranch& b, bool reversed);

/// Finds the isomorphisms of two graphs whose difference is at most `tolerance` above the least, by
/// branch and bound. After some million steps the search ends, incomplete. Throws Aborted.
GraphMatches FindMatches(const BranchGraph& graph, const BranchGraph& target, double tolerance,
  const Progress& progress = {});

} // namespace shape
