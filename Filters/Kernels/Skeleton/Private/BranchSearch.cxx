#include "Skeleton/Private/BranchSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

constexpr std::size_t MostMatches = 256;
/// Triples of directions that span less are too close to a plane to tell left from right.
constexpr double LeastVolume = 0.6;
constexpr double TurnWeight = 2.0;
/// Radii below this share of the skeleton's length are compared as if they were that large.
constexpr double LeastRadius = 1e-3;

class Search
{
public:
  Search(const BranchGraph& graph, const BranchGraph& target, double tolerance,
    SearchBudget& budget, const Progress& progress)
    : Graph(graph)
    , Target(target)
    , Tolerance(tolerance)
    , Budget(budget)
    , Report(progress)
    , SideTo(2 * graph.Branches.size(), -1)
    , NodeTo(graph.Nodes.size(), -1)
    , NodeFrom(target.Nodes.size(), -1)
    , Used(target.Branches.size(), false)
  {
  }

  GraphMatches Run()
  {
    this->OrderBranches();
    this->BoundBelow();
    this->Extend(0, 0.0);
    auto& found = this->Matches.Found;
    std::stable_sort(found.begin(), found.end(),
      [](const GraphMatch& a, const GraphMatch& b) { return a.Difference < b.Difference; });
    while (!found.empty() && found.back().Difference > this->Best + this->Tolerance)
    {
      found.pop_back();
    }
    return std::move(this->Matches);
  }

private:
  /// Each branch but the first of its component has a node in common with an earlier one.
  void OrderBranches()
  {
    std::vector<int> byLength(this->Graph.Branches.size());
    for (std::size_t i = 0; i < byLength.size(); ++i)
    {
      byLength[i] = static_cast<int>(i);
    }
    std::stable_sort(byLength.begin(), byLength.end(),
      [&](int a, int b)
      { return this->Graph.Branches[a].Length > this->Graph.Branches[b].Length; });
    std::vector<bool> taken(byLength.size(), false), reached(this->Graph.Nodes.size(), false);
    while (this->Order.size() < byLength.size())
    {
      // The longest one at a node that is reached, otherwise the longest of another component.
      const auto touches = [&](int i)
      {
        const auto& nodes = this->Graph.Branches[i].Nodes;
        return !taken[i] && (reached[nodes[0]] || reached[nodes[1]]);
      };
      auto next = std::find_if(byLength.begin(), byLength.end(), touches);
      if (next == byLength.end())
      {
        next = std::find_if(byLength.begin(), byLength.end(), [&](int i) { return !taken[i]; });
      }
      taken[*next] = true;
      for (const int node : this->Graph.Branches[*next].Nodes)
      {
        reached[node] = true;
      }
      this->Order.push_back(*next);
    }
  }

  /// Rest[i]: the least difference of the branches from the i-th on.
  void BoundBelow()
  {
    this->Rest.assign(this->Order.size() + 1, 0.0);
    for (std::size_t i = this->Order.size(); i-- > 0;)
    {
      double least = std::numeric_limits<double>::infinity();
      for (const GraphBranch& other : this->Target.Branches)
      {
        for (const bool reversed : { false, true })
        {
          least =
            std::min(least, CompareBranches(this->Graph.Branches[this->Order[i]], other, reversed));
        }
      }
      this->Rest[i] = this->Rest[i + 1] + least;
    }
  }

  void Extend(std::size_t depth, double difference)
  {
    const double most = std::min(this->Best + this->Tolerance, this->Budget.AtMost);
    if (difference + this->Rest[depth] > most || !this->Matches.Complete)
    {
      return;
    }
    if (depth == this->Order.size())
    {
      this->Best = std::min(this->Best, difference);
      this->Matches.Found.push_back({ this->SideTo, difference });
      this->Matches.Complete = this->Matches.Found.size() < MostMatches;
      return;
    }
    if (--this->Budget.Steps % 1024 == 0)
    {
      this->Report(1.0 - std::max(0.0, this->Budget.Steps / (1.0 * SearchBudget().Steps)));
    }
    this->Matches.Complete = this->Budget.Steps > 0;
    const int branch = this->Order[depth];
    for (const auto& [own, other, reversed] : this->Candidates(branch))
    {
      std::vector<int> mapped;
      double turns = 0.0;
      if (this->Assign(branch, other, reversed, mapped, turns))
      {
        this->Extend(depth + 1, difference + own + turns);
      }
      this->Withdraw(branch, other, mapped);
    }
  }

  using Candidate = std::tuple<double, int, bool>;

  std::vector<Candidate> Candidates(int branch) const
  {
    const GraphBranch& own = this->Graph.Branches[branch];
    std::vector<Candidate> found;
    for (int other = 0; other < static_cast<int>(this->Target.Branches.size()); ++other)
    {
      for (const bool reversed : { false, true })
      {
        // A point or cycle has one direction; MatchSkeletons knows that a cycle has others.
        if (!this->Used[other] && !(reversed && own.Type != GraphBranch::Kind::Open))
        {
          const double difference = CompareBranches(own, this->Target.Branches[other], reversed);
          if (std::isfinite(difference))
          {
            found.emplace_back(difference, other, reversed);
          }
        }
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Maps a branch and its nodes. Returns false if that is impossible. mapped: the nodes that had
  /// no counterpart before.
  bool Assign(int branch, int other, bool reversed, std::vector<int>& mapped, double& turns)
  {
    this->Used[other] = true;
    for (int end = 0; end < 2; ++end)
    {
      const int node = this->Graph.Branches[branch].Nodes[end];
      const int to = this->Target.Branches[other].Nodes[end ^ static_cast<int>(reversed)];
      this->SideTo[2 * branch + end] = 2 * other + (end ^ static_cast<int>(reversed));
      if (this->NodeTo[node] < 0 && this->NodeFrom[to] < 0 &&
        this->Graph.Nodes[node].Sides.size() == this->Target.Nodes[to].Sides.size())
      {
        this->NodeTo[node] = to;
        this->NodeFrom[to] = node;
        mapped.push_back(node);
      }
      if (this->NodeTo[node] != to)
      {
        return false;
      }
    }
    const auto& nodes = this->Graph.Branches[branch].Nodes;
    turns = this->CompareTurns(nodes[0]);
    if (nodes[1] != nodes[0])
    {
      turns += this->CompareTurns(nodes[1]);
    }
    return true;
  }

  void Withdraw(int branch, int other, const std::vector<int>& mapped)
  {
    this->Used[other] = false;
    this->SideTo[2 * branch] = this->SideTo[2 * branch + 1] = -1;
    for (const int node : mapped)
    {
      this->NodeFrom[this->NodeTo[node]] = -1;
      this->NodeTo[node] = -1;
    }
  }

  static double Volume(const BranchGraph& graph, int a, int b, int c)
  {
    const Eigen::RowVector3d u = graph.Directions.row(a), v = graph.Directions.row(b),
                             w = graph.Directions.row(c);
    return u.cross(v).dot(w);
  }

  /// How far the branches around a node turn the other way; 0 until all are mapped.
  double CompareTurns(int node) const
  {
    const std::vector<int>& sides = this->Graph.Nodes[node].Sides;
    const auto to = [&](std::size_t i) { return this->SideTo[sides[i]]; };
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      if (to(i) < 0)
      {
        return 0.0;
      }
      for (std::size_t j = i + 1; j < sides.size(); ++j)
      {
        for (std::size_t k = j + 1; k < sides.size() && to(j) >= 0 && to(k) >= 0; ++k)
        {
          const double own = Volume(this->Graph, sides[i], sides[j], sides[k]);
          const double other = Volume(this->Target, to(i), to(j), to(k));
          const double least = std::min(std::abs(own), std::abs(other));
          sum += own * other < 0.0 && least > LeastVolume ? least : 0.0;
          ++count;
        }
      }
    }
    return count > 0 ? TurnWeight * sum / count : 0.0;
  }

  const BranchGraph& Graph;
  const BranchGraph& Target;
  double Tolerance;
  SearchBudget& Budget;
  const Progress& Report;
  std::vector<int> Order;
  std::vector<double> Rest;
  std::vector<int> SideTo, NodeTo, NodeFrom;
  std::vector<bool> Used;
  double Best = std::numeric_limits<double>::infinity();
  GraphMatches Matches;
};

} // namespace

double CompareBranches(const GraphBranch& a, const GraphBranch& b, bool reversed)
{
  if (a.Type != b.Type)
  {
    return std::numeric_limits<double>::infinity();
  }
  double radii = 0.0;
  for (int k = 0; k < RadiusSamples; ++k)
  {
    const double other = b.Radii[reversed ? RadiusSamples - 1 - k : k];
    radii += std::abs(std::log(std::max(a.Radii[k], LeastRadius) / std::max(other, LeastRadius)));
  }
  return std::abs(std::log(a.Length / b.Length)) + radii / RadiusSamples;
}

GraphMatches FindMatches(const BranchGraph& graph, const BranchGraph& target, double tolerance,
  SearchBudget& budget, const Progress& progress)
{
  if (graph.Branches.size() != target.Branches.size() || graph.Nodes.size() != target.Nodes.size())
  {
    return {};
  }
  return Search(graph, target, tolerance, budget, progress).Run();
}

} // namespace shape
