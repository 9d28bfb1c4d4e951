#include "Skeleton/SkeletonMatching.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Skeleton/Private/BranchGraph.h"
#include "Skeleton/Private/BranchSearch.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

std::string Describe(const BranchGraph& graph)
{
  int ends = 0, junctions = 0;
  for (const GraphNode& node : graph.Nodes)
  {
    ends += node.Sides.size() == 1;
    junctions += node.Sides.size() > 2;
  }
  return std::to_string(graph.Branches.size()) + " branch(es), " + std::to_string(ends) +
    " end(s) and " + std::to_string(junctions) + " junction(s)";
}

/// "2, 3 and 5"
std::string List(const std::vector<int>& numbers)
{
  std::string words;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    words += (i == 0 ? "" : i + 1 < numbers.size() ? ", " : " and ") + std::to_string(numbers[i]);
  }
  return words;
}

/// Returns the branches that any of the matches maps otherwise than the first, and cycles.
std::vector<int> FindAmbiguous(const BranchGraph& graph, const GraphMatches& matches)
{
  std::set<int> found;
  for (const GraphBranch& branch : graph.Branches)
  {
    if (branch.Type == GraphBranch::Kind::Cycle)
    {
      found.insert(branch.Number);
    }
  }
  const std::vector<int>& best = matches.Found.front().Sides;
  for (const GraphMatch& match : matches.Found)
  {
    for (std::size_t side = 0; side < best.size(); ++side)
    {
      if (match.Sides[side] != best[side])
      {
        found.insert(graph.Branches[side / 2].Number);
      }
    }
  }
  return { found.begin(), found.end() };
}

void RequireSimilar(
  const BranchGraph& graph, const BranchGraph& target, const GraphMatch& match, double largest)
{
  for (std::size_t i = 0; i < graph.Branches.size(); ++i)
  {
    const int side = match.Sides[2 * i];
    const GraphBranch& other = target.Branches[side / 2];
    const double difference = CompareBranches(graph.Branches[i], other, side % 2 == 1);
    if (difference > largest)
    {
      throw InvalidInput("branch " + std::to_string(graph.Branches[i].Number) +
        " of the skeleton and branch " + std::to_string(other.Number) +
        " of the target's would match, but they differ by " + FormatNumber(difference) +
        " in length and radius, more than " + FormatNumber(largest) +
        "; choose another target, or a Resolution with which both skeletons have the same "
        "branches");
    }
  }
}

void RequireClear(const SkeletonMatching& matching, const GraphMatches& matches,
  const SkeletonMatchingOptions& options)
{
  const std::string remedy = "; use shapes whose parts differ, or set Ambiguous to First and check "
                             "the result";
  if (options.Ambiguous == SkeletonMatchingOptions::AmbiguityType::First)
  {
    return;
  }
  if (!matching.Ambiguous.empty())
  {
    throw InvalidInput("the matching is ambiguous: branches " + List(matching.Ambiguous) +
      " of the skeleton match the target as well in another way" + remedy +
      " (without Target, the output shows the numbers of the branches in BranchId)");
  }
  if (!matches.Complete)
  {
    throw InvalidInput("there are too many ways to match the branches to compare all" + remedy);
  }
}

/// Returns the position at a fraction of the length of a branch.
RowVector3d PlaceAt(const CurveSkeleton& skeleton, const std::vector<int>& branch, double fraction)
{
  const Eigen::VectorXd along = MeasureAlong(skeleton, branch);
  const double at = fraction * along.tail<1>()(0);
  std::size_t piece = 1;
  while (piece + 1 < branch.size() && along(piece) < at)
  {
    ++piece;
  }
  if (piece >= branch.size())
  {
    return skeleton.Points.row(branch.front());
  }
  const double length = along(piece) - along(piece - 1);
  const double share = length > 0.0 ? std::clamp((at - along(piece - 1)) / length, 0.0, 1.0) : 0.0;
  return (1.0 - share) * skeleton.Points.row(branch[piece - 1]) +
    share * skeleton.Points.row(branch[piece]);
}

/// Sums of positions, of which Mean is the mean.
struct PlaceSum
{
  RowVector3d Sum = RowVector3d::Zero();
  int Count = 0;
  void Add(const RowVector3d& place)
  {
    this->Sum += place;
    ++this->Count;
  }
  RowVector3d Mean() const { return this->Sum / this->Count; }
};

/// Fills in TargetPositions. A junction goes to the mean of where the branches at it begin.
void PlacePoints(const CurveSkeleton& skeleton, const CurveSkeleton& target,
  const BranchGraph& graph, SkeletonMatching& matching)
{
  std::vector<PlaceSum> points(skeleton.Points.rows()), nodes(graph.Nodes.size());
  const auto fractions = [&](const std::vector<int>& branch)
  {
    const Eigen::VectorXd along = MeasureAlong(skeleton, branch);
    return Eigen::VectorXd(along / std::max(along.tail<1>()(0), 1e-300));
  };
  for (std::size_t i = 0; i < skeleton.Branches.size(); ++i)
  {
    const std::vector<int>& branch = skeleton.Branches[i];
    const Eigen::VectorXd fraction = fractions(branch);
    for (std::size_t k = 0; k < branch.size() && matching.Branches[i] >= 0; ++k)
    {
      const double at = matching.Reversed[i] ? 1.0 - fraction(k) : fraction(k);
      const RowVector3d place = PlaceAt(target, target.Branches[matching.Branches[i]], at);
      points[branch[k]].Add(place);
      if (graph.NodeOf[branch[k]] >= 0)
      {
        nodes[graph.NodeOf[branch[k]]].Add(place);
      }
    }
  }
  matching.TargetPositions.resize(skeleton.Points.rows(), 3);
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    // A junction of inner branches alone, or a point of an inner branch, which follows.
    const int node = graph.NodeOf[p];
    matching.TargetPositions.row(p) = points[p].Count > 0 ? points[p].Mean()
      : node >= 0                                         ? nodes[node].Mean()
                                                          : RowVector3d::Zero();
  }
  for (std::size_t i = 0; i < skeleton.Branches.size(); ++i)
  {
    const std::vector<int>& branch = skeleton.Branches[i];
    const Eigen::VectorXd fraction = fractions(branch);
    const RowVector3d from = matching.TargetPositions.row(branch.front()),
                      to = matching.TargetPositions.row(branch.back());
    for (std::size_t k = 1; k + 1 < branch.size() && matching.Branches[i] < 0; ++k)
    {
      matching.TargetPositions.row(branch[k]) = (1.0 - fraction(k)) * from + fraction(k) * to;
    }
  }
}

} // namespace

void RequireMatchingOptions(const SkeletonMatchingOptions& options)
{
  RequireOption(std::isfinite(options.Tolerance) && options.Tolerance > 0.0, "Tolerance",
    options.Tolerance, "positive and finite");
  RequireOption(std::isfinite(options.LargestDifference) && options.LargestDifference > 0.0,
    "Largest Difference", options.LargestDifference, "positive and finite");
}

SkeletonMatching MatchSkeletons(const CurveSkeleton& skeleton, const CurveSkeleton& target,
  const SkeletonMatchingOptions& options, const Progress& progress)
{
  RequireMatchingOptions(options);
  const BranchGraph graph = MakeBranchGraph(skeleton), other = MakeBranchGraph(target);
  const GraphMatches matches = FindMatches(graph, other, options.Tolerance, progress);
  if (matches.Found.empty())
  {
    throw InvalidInput("the skeletons are different graphs: one has " + Describe(graph) +
      ", the target's has " + Describe(other) +
      "; choose a target with the same parts, or a Resolution with which both skeletons have the "
      "same branches");
  }
  const GraphMatch& best = matches.Found.front();
  RequireSimilar(graph, other, best, options.LargestDifference);
  SkeletonMatching matching;
  matching.Difference = best.Difference;
  matching.Ambiguous = FindAmbiguous(graph, matches);
  RequireClear(matching, matches, options);
  matching.Branches.assign(skeleton.Branches.size(), -1);
  matching.Reversed.assign(skeleton.Branches.size(), false);
  for (std::size_t i = 0; i < graph.Branches.size(); ++i)
  {
    const int side = best.Sides[2 * i];
    matching.Branches[graph.Branches[i].Number] = other.Branches[side / 2].Number;
    matching.Reversed[graph.Branches[i].Number] = side % 2 == 1;
  }
  PlacePoints(skeleton, target, graph, matching);
  progress(1.0);
  return matching;
}

} // namespace shape
