#include "Hex/Features/Private/DisjointPaths.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/successive_shortest_path_nonnegative_weights.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

struct FlowArc;
using FlowTraits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using FlowGraph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, FlowArc>;

struct FlowArc
{
  int Capacity = 0, Residual = 0;
  double Cost = 0.0;
  FlowTraits::edge_descriptor Reverse;
};

/// Adds an arc of capacity 1 and its reverse, of capacity 0, which successive shortest paths need.
void AddArc(FlowGraph& flow, int from, int to, double cost)
{
  const auto ahead = add_edge(from, to, flow).first;
  const auto back = add_edge(to, from, flow).first;
  flow[ahead] = { 1, 0, cost, back };
  flow[back] = { 0, 0, -cost, ahead };
}

// Node i of the graph has the entry 2 i and the exit 2 i + 1 in the flow; the sink is last.
int EntryOf(int node)
{
  return 2 * node;
}

int ExitOf(int node)
{
  return 2 * node + 1;
}

} // namespace

std::optional<std::vector<std::pair<int, int>>> FindDisjointPaths(
  const CostGraph& graph, int from, const std::vector<int>& ends)
{
  double largest = *std::max_element(graph.NodeCosts.begin(), graph.NodeCosts.end());
  for (const auto& [edge, cost] : graph.EdgeCosts)
  {
    largest = std::max(largest, cost);
  }
  const double unit = std::ldexp(largest, -32);
  // Integers: rounding must not make the reduced cost of an arc negative.
  const auto inUnits = [&](double cost) { return unit > 0.0 ? std::round(cost / unit) : 0.0; };

  const auto nodes = static_cast<int>(graph.NodeCosts.size());
  const int sink = 2 * nodes;
  FlowGraph flow(2 * static_cast<std::size_t>(nodes) + 1);
  for (int node = 0; node < nodes; ++node)
  {
    AddArc(flow, EntryOf(node), ExitOf(node), inUnits(graph.NodeCosts[node]));
  }
  for (const auto& [edge, cost] : graph.EdgeCosts)
  {
    AddArc(flow, ExitOf(edge.first), EntryOf(edge.second), inUnits(cost));
    AddArc(flow, ExitOf(edge.second), EntryOf(edge.first), inUnits(cost));
  }
  for (const int end : ends)
  {
    AddArc(flow, ExitOf(end), sink, 0.0);
  }
  boost::successive_shortest_path_nonnegative_weights(flow, ExitOf(from), sink,
    boost::capacity_map(get(&FlowArc::Capacity, flow))
      .residual_capacity_map(get(&FlowArc::Residual, flow))
      .weight_map(get(&FlowArc::Cost, flow))
      .reverse_edge_map(get(&FlowArc::Reverse, flow)));
  std::vector<std::pair<int, int>> steps;
  for (const auto arc : boost::make_iterator_range(edges(flow)))
  {
    const auto begin = static_cast<int>(source(arc, flow)),
               end = static_cast<int>(target(arc, flow));
    const bool isUsed = flow[arc].Capacity > flow[arc].Residual;
    if (end == sink && !isUsed)
    {
      return std::nullopt;
    }
    if (end != sink && begin % 2 == 1 && isUsed)
    {
      steps.emplace_back(begin / 2, end / 2);
    }
  }
  return steps;
}

} // namespace shape
