#include "Skeleton/SkeletonMatching.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Skeleton/Private/VariantSearch.h"

#include <algorithm>
#include <cmath>
#include <map>
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

/// Returns the sides that are ends, by the point of the whole skeleton.
std::map<int, int> ListTips(const GraphVariant& variant)
{
  std::map<int, int> tips;
  for (const GraphNode& node : variant.Graph.Nodes)
  {
    if (node.Sides.size() == 1)
    {
      const int side = node.Sides[0];
      const std::vector<int>& branch =
        variant.Skeleton.Branches[variant.Graph.Branches[side / 2].Number];
      tips.emplace(variant.Points[side % 2 ? branch.back() : branch.front()], side);
    }
  }
  return tips;
}

/// Where a match takes each end: from points to points of the whole skeletons.
std::map<int, int> MapTips(const VariantMatches& pair, const GraphMatch& match)
{
  std::map<int, int> pointOf, result;
  for (const auto& [point, side] : ListTips(*pair.Target))
  {
    pointOf.emplace(side, point);
  }
  for (const auto& [point, side] : ListTips(*pair.Own))
  {
    result.emplace(point, pointOf.at(match.Sides[side]));
  }
  return result;
}

/// Returns the branches (numbers of the whole skeleton) that any of the matches maps otherwise than
/// the best one, and cycles. Matches of other variants are compared by their ends.
std::vector<int> FindAmbiguous(const std::vector<VariantMatches>& pairs)
{
  const VariantMatches& first = pairs.front();
  const GraphVariant& own = *first.Own;
  std::set<int> found;
  const auto insert = [&](int branch)
  { found.insert(own.Numbers[own.Graph.Branches[branch].Number]); };
  for (int i = 0; i < static_cast<int>(own.Graph.Branches.size()); ++i)
  {
    if (own.Graph.Branches[i].Type == GraphBranch::Kind::Cycle)
    {
      insert(i);
    }
  }
  const std::vector<int>& best = first.Found.front().Sides;
  for (const GraphMatch& match : first.Found)
  {
    for (int side = 0; side < static_cast<int>(best.size()); ++side)
    {
      if (match.Sides[side] != best[side])
      {
        insert(side / 2);
      }
    }
  }
  const std::map<int, int> tips = ListTips(own), places = MapTips(first, first.Found.front());
  for (std::size_t i = 1; i < pairs.size(); ++i)
  {
    for (const GraphMatch& match : pairs[i].Found)
    {
      for (const auto& [point, place] : MapTips(pairs[i], match))
      {
        const auto known = places.find(point);
        if (known != places.end() && known->second != place)
        {
          insert(tips.at(point) / 2);
        }
      }
    }
  }
  return { found.begin(), found.end() };
}

void RequireSimilar(const VariantMatches& pair, double largest)
{
  const GraphVariant &own = *pair.Own, &target = *pair.Target;
  for (std::size_t i = 0; i < own.Graph.Branches.size(); ++i)
  {
    const int side = pair.Found.front().Sides[2 * i];
    const GraphBranch &branch = own.Graph.Branches[i], &other = target.Graph.Branches[side / 2];
    const double difference = CompareBranches(branch, other, side % 2 == 1);
    if (difference > largest)
    {
      throw InvalidInput("branch " + std::to_string(own.Numbers[branch.Number]) +
        " of the skeleton and branch " + std::to_string(target.Numbers[other.Number]) +
        " of the target's would match, but they differ by " + FormatNumber(difference) +
        " in length and radius, more than " + FormatNumber(largest) +
        "; choose another target, or a Resolution with which both skeletons have the same "
        "branches");
    }
  }
}

void RequireClear(
  const SkeletonMatching& matching, bool complete, const SkeletonMatchingOptions& options)
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
  if (!complete)
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
void PlacePoints(const CurveSkeleton& target, const BranchGraph& graph, SkeletonMatching& matching)
{
  const CurveSkeleton& skeleton = matching.Skeleton;
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
  RequireOption(options.LargestOmission >= 0.0 && options.LargestOmission <= 0.5,
    "Largest Omission", options.LargestOmission, "between 0 and 0.5");
}

SkeletonMatching MatchSkeletons(const CurveSkeleton& skeleton, const CurveSkeleton& target,
  const SkeletonMatchingOptions& options, const Progress& progress)
{
  RequireMatchingOptions(options);
  const std::vector<GraphVariant> variants = MakeVariants(skeleton, options.LargestOmission),
                                  targets = MakeVariants(target, options.LargestOmission);
  const VariantSearchResult search =
    FindVariantMatches(variants, targets, options.Tolerance, progress);
  if (search.Pairs.empty())
  {
    throw InvalidInput("the skeletons are different graphs: one has " +
      Describe(variants.front().Graph) + ", the target's has " + Describe(targets.front().Graph) +
      "; choose a target with the same parts, or a Resolution with which both skeletons have the "
      "same branches");
  }
  const VariantMatches& best = search.Pairs.front();
  RequireSimilar(best, options.LargestDifference);
  SkeletonMatching matching;
  matching.Skeleton = best.Own->Skeleton;
  matching.Numbers = best.Own->Numbers;
  matching.LeftOut = best.Own->LeftOut;
  matching.TargetLeftOut = best.Target->LeftOut;
  matching.Difference = best.Difference;
  matching.Ambiguous = FindAmbiguous(search.Pairs);
  RequireClear(matching, search.Complete, options);
  const BranchGraph &graph = best.Own->Graph, &other = best.Target->Graph;
  std::vector<int> partner(matching.Skeleton.Branches.size(), -1);
  matching.Reversed.assign(partner.size(), false);
  for (std::size_t i = 0; i < graph.Branches.size(); ++i)
  {
    const int side = best.Found.front().Sides[2 * i];
    partner[graph.Branches[i].Number] = other.Branches[side / 2].Number;
    matching.Reversed[graph.Branches[i].Number] = side % 2 == 1;
  }
  matching.Branches = partner; // of the variant, until the points have their places
  PlacePoints(best.Target->Skeleton, graph, matching);
  for (int& branch : matching.Branches)
  {
    branch = branch < 0 ? -1 : best.Target->Numbers[branch];
  }
  progress(1.0);
  return matching;
}

} // namespace shape
