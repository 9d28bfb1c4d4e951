#include "Skeleton/Private/VariantSearch.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace shape
{
namespace
{

/// The numbers of branches at the nodes, ascending: isomorphic graphs have the same.
std::vector<int> Signature(const BranchGraph& graph)
{
  std::vector<int> degrees;
  for (const GraphNode& node : graph.Nodes)
  {
    degrees.push_back(static_cast<int>(node.Sides.size()));
  }
  std::sort(degrees.begin(), degrees.end());
  return degrees;
}

/// The pairs that may be isomorphic, by cost.
std::vector<std::tuple<double, int, int>> ListPairs(
  const std::vector<GraphVariant>& variants, const std::vector<GraphVariant>& targets)
{
  std::map<std::vector<int>, std::vector<int>> bySignature;
  for (int j = 0; j < static_cast<int>(targets.size()); ++j)
  {
    bySignature[Signature(targets[j].Graph)].push_back(j);
  }
  std::vector<std::tuple<double, int, int>> pairs;
  for (int i = 0; i < static_cast<int>(variants.size()); ++i)
  {
    for (const int j : bySignature[Signature(variants[i].Graph)])
    {
      pairs.emplace_back(variants[i].Cost + targets[j].Cost, i, j);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

} // namespace

VariantSearchResult FindVariantMatches(const std::vector<GraphVariant>& variants,
  const std::vector<GraphVariant>& targets, double tolerance, const Progress& progress)
{
  VariantSearchResult result;
  SearchBudget budget;
  double best = std::numeric_limits<double>::infinity();
  for (const auto& [cost, i, j] : ListPairs(variants, targets))
  {
    if (cost > best + tolerance || !result.Complete)
    {
      break;
    }
    budget.AtMost = best + tolerance - cost;
    GraphMatches matches =
      FindMatches(variants[i].Graph, targets[j].Graph, tolerance, budget, progress);
    result.Complete = matches.Complete;
    if (!matches.Found.empty())
    {
      const double difference = cost + matches.Found.front().Difference;
      best = std::min(best, difference);
      result.Pairs.push_back({ &variants[i], &targets[j], std::move(matches.Found), difference });
    }
  }
  auto& pairs = result.Pairs;
  std::stable_sort(pairs.begin(), pairs.end(),
    [](const VariantMatches& a, const VariantMatches& b) { return a.Difference < b.Difference; });
  for (VariantMatches& pair : pairs)
  {
    const double most = best + tolerance - pair.Own->Cost - pair.Target->Cost;
    const auto tooFar = [&](const GraphMatch& match) { return match.Difference > most; };
    pair.Found.erase(
      std::remove_if(pair.Found.begin(), pair.Found.end(), tooFar), pair.Found.end());
  }
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                [](const VariantMatches& pair) { return pair.Found.empty(); }),
    pairs.end());
  return result;
}

} // namespace shape
