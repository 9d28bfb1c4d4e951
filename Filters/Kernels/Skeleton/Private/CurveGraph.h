#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// A graph of nodes in space. Two nodes may have several links, and a link may join a node to
/// itself.
struct CurveGraph
{
  std::vector<Eigen::Vector3d> Positions;
  std::vector<double> Masses; ///< how many points of the surface each node represents; > 0
  std::vector<std::pair<int, int>> Links;

  int Size() const { return static_cast<int>(this->Positions.size()); }
};

/// Counts the connected components of a graph.
int CountComponents(const CurveGraph& graph);

/// Returns the number of independent cycles of a graph: links - nodes + components.
int CountCycles(const CurveGraph& graph);

/// Merges the nodes of links that are shorter than `length`, the shortest first. A link of a cycle
/// of one, two or three links stays, so that every cycle stays.
CurveGraph MergeShortLinks(const CurveGraph& graph, double length);

/// Removes the nodes for which `removed` is true, and their links.
CurveGraph RemoveNodes(const CurveGraph& graph, const std::vector<bool>& removed);

/// Returns the links of each node, ascending. A link that joins a node to itself is there twice.
std::vector<std::vector<int>> ListLinksOfNodes(const CurveGraph& graph);

/// Returns the paths of nodes between nodes that have other than two links. A closed path begins
/// and ends with the same node. A node without links is a path of one node.
std::vector<std::vector<int>> TracePaths(const CurveGraph& graph);

} // namespace shape
