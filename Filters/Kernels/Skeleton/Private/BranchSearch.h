#pragma once

#include "Base/Progress.h"
#include "Skeleton/Private/BranchGraph.h"

#include <limits>
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

/// What searches may still do.
struct SearchBudget
{
  double AtMost = std::numeric_limits<double>::infinity(); ///< the greatest difference of interest
  long long Steps = 2000000;                               ///< that all searches together have left
};

/// Finds the isomorphisms of two graphs whose difference is at most `tolerance` above the least, by
/// branch and bound. If the budget has no steps left, the search ends, incomplete. Throws Aborted.
GraphMatches FindMatches(const BranchGraph& graph, const BranchGraph& target, double tolerance,
  SearchBudget& budget, const Progress& progress = {});

} // namespace shape
