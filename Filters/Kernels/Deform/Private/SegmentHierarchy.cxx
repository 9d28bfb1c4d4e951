#include "Deform/Private/SegmentHierarchy.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <utility>

namespace shape
{
namespace
{

/// The restriction of a problem to some of its nodes, of which the first are its sources. number:
/// -1 for each node of the whole problem, before and after.
NodeProblem Restricted(
  const NodeProblem& problem, const std::vector<int>& nodes, int sources, std::vector<int>& number)
{
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    number[nodes[i]] = static_cast<int>(i);
  }
  NodeProblem part;
  part.Graph.Positions = problem.Graph.Positions(nodes, Eigen::all);
  part.Graph.Weights = problem.Graph.Weights(nodes);
  part.Graph.MeanLength = problem.Graph.MeanLength;
  std::vector<std::pair<int, int>> links;
  for (const int node : nodes)
  {
    for (int k = problem.Graph.First[node]; k < problem.Graph.First[node + 1]; ++k)
    {
      const int other = problem.Graph.Neighbours[k];
      if (number[other] >= 0 && node < other)
      {
        links.emplace_back(number[node], number[other]);
      }
    }
  }
  SetLinks(part.Graph, std::move(links));
  for (int i = 0; i < sources; ++i)
  {
    part.Sources.push_back(i);
  }
  part.Powers = problem.Powers(nodes);
  part.Scales = problem.Scales(nodes);
  part.Front = problem.Front;
  for (const int node : nodes)
  {
    number[node] = -1;
  }
  return part;
}

} // namespace

/// Section 2.3, Fig. 9: parts are deformed one after another, from the boundary inwards. The handle
/// of a part is the layer of nodes next to it in the parts that come before.
SegmentHierarchy::SegmentHierarchy(NodeProblem problem, const Eigen::VectorXi& labels,
  const NodeSolver& solve, const Progress& progress)
  : Sources(problem.Sources)
  , Size(problem.Graph.Size())
{
  const PointGraph& graph = problem.Graph;
  const FrontSweep sweep = SweepFront(graph, problem.Sources, progress.Part(0.0, 0.1));
  DisjointSets sets(this->Size);
  // A part is connected: two regions with the same label are two parts.
  for (const auto& [a, b] : ListLinks(graph))
  {
    // Sources belong to no part: joined across them, parts of one label would be one.
    const bool free = sweep.Ranks[a] >= sweep.Sources && sweep.Ranks[b] >= sweep.Sources;
    if (free && labels(a) == labels(b))
    {
      sets.Merge(a, b);
    }
  }
  // Parts in the order in which the front reaches them; sources come before all.
  std::vector<int> partOf(this->Size, -1);
  std::vector<std::vector<int>> members;
  for (int rank = sweep.Sources; rank < this->Size; ++rank)
  {
    const int root = sets.Find(sweep.Nodes[rank]);
    if (partOf[root] < 0)
    {
      partOf[root] = static_cast<int>(members.size());
      members.emplace_back();
      this->Parts.push_back({ {}, 0, sweep.Arrivals[rank], nullptr });
    }
    partOf[sweep.Nodes[rank]] = partOf[root];
    members[partOf[root]].push_back(sweep.Nodes[rank]);
  }
  std::vector<int> takenBy(this->Size, -1), number(this->Size, -1);
  for (int p = 0; p < static_cast<int>(this->Parts.size()); ++p)
  {
    Part& part = this->Parts[p];
    for (const int node : members[p])
    {
      for (int k = graph.First[node]; k < graph.First[node + 1]; ++k)
      {
        const int other = graph.Neighbours[k];
        // Sources have part -1, so they come before all.
        if (partOf[other] < p && takenBy[other] != p)
        {
          takenBy[other] = p;
          part.Nodes.push_back(other);
        }
      }
    }
    std::sort(part.Nodes.begin(), part.Nodes.end());
    if (this->Parts.size() == 1)
    {
      part.Nodes = problem.Sources; // including those that are only adjacent to other sources
    }
    part.Sources = static_cast<int>(part.Nodes.size());
    part.Nodes.insert(part.Nodes.end(), members[p].begin(), members[p].end());
    const auto share = [&](int i)
    { return 0.1 + 0.9 * i / static_cast<double>(this->Parts.size()); };
    part.Solution = solve(
      Restricted(problem, part.Nodes, part.Sources, number), progress.Part(share(p), share(p + 1)));
    this->Empty += part.Solution->EmptyBands();
    this->Zero += part.Solution->ZeroWeights();
    this->Base += part.Solution->BaseNodes();
    this->Streamed = this->Streamed || part.Solution->IsStreamed();
  }
}

/// In the order of arrival: the nodes that drive a part are moved before it.
NodeTransforms SegmentHierarchy::Move(
  const NodeTransforms& sources, double reach, const Progress& progress) const
{
  NodeTransforms motions{ Eigen::MatrixXd::Zero(3, this->Size),
    std::vector<Eigen::Matrix3d>(this->Size, Eigen::Matrix3d::Identity()) };
  for (std::size_t i = 0; i < this->Sources.size(); ++i)
  {
    motions.Shifts.col(this->Sources[i]) = sources.Shifts.col(static_cast<Eigen::Index>(i));
    motions.Rotations[this->Sources[i]] = sources.Rotations[i];
  }
  const double parts = static_cast<double>(this->Parts.size());
  for (std::size_t p = 0; p < this->Parts.size() && this->Parts[p].Arrival <= reach; ++p)
  {
    const Part& part = this->Parts[p];
    NodeTransforms given{ Eigen::MatrixXd(3, part.Sources), {} };
    for (int i = 0; i < part.Sources; ++i)
    {
      given.Shifts.col(i) = motions.Shifts.col(part.Nodes[i]);
      given.Rotations.push_back(motions.Rotations[part.Nodes[i]]);
    }
    const double done = static_cast<double>(p) / parts;
    const NodeTransforms found = part.Solution->Move(
      given, std::numeric_limits<double>::infinity(), progress.Part(done, done + 1.0 / parts));
    for (std::size_t i = part.Sources; i < part.Nodes.size(); ++i)
    {
      motions.Shifts.col(part.Nodes[i]) = found.Shifts.col(static_cast<Eigen::Index>(i));
      motions.Rotations[part.Nodes[i]] = found.Rotations[i];
    }
  }
  return motions;
}

} // namespace shape
