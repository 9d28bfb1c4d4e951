#include "Geometry/GraphComponents.h"

#include "Base/DisjointSets.h"
#include "Search/PointTree.h"

#include <limits>
#include <map>
#include <utility>

namespace shape
{
namespace
{

/// A link from a component to another one.
struct Way
{
  double Length = std::numeric_limits<double>::infinity();
  int From = -1, To = -1;
};

} // namespace

int ConnectComponents(PointGraph& graph, const std::vector<int>& mainland, const Progress& progress)
{
  const int n = graph.Size();
  DisjointSets pieces(n);
  std::vector<std::pair<int, int>> links = ListLinks(graph);
  for (const auto& [a, b] : links)
  {
    pieces.Merge(a, b);
  }
  for (const int node : mainland)
  {
    pieces.Merge(node, mainland.front());
  }
  int islands = 0;
  for (int i = 0; i < n; ++i)
  {
    islands += pieces.Find(i) == i;
  }
  --islands; // not counting the mainland
  if (islands == 0)
  {
    return 0;
  }
  // In each round every island is linked to the nearest other component (Boruvka's algorithm), so
  // few rounds are enough; the mainland need not search.
  const PointTree tree(graph.Positions);
  for (int left = islands; left > 0;)
  {
    std::map<int, Way> ways;
    const int main = pieces.Find(mainland.front());
    for (int i = 0; i < n; ++i)
    {
      if (i % 4096 == 0)
      {
        progress(1.0 - static_cast<double>(left) / islands);
      }
      const int own = pieces.Find(i);
      if (own != main)
      {
        Way& way = ways[own];
        const int to = tree.NearestOf(
          graph.Positions.row(i), [&](int j) { return pieces.Find(j) != own; }, way.Length);
        if (to >= 0)
        {
          way = { (graph.Positions.row(i) - graph.Positions.row(to)).norm(), i, to };
        }
      }
    }
    for (const auto& [piece, way] : ways)
    {
      // Two islands may have chosen each other, or the links of this round may close a cycle.
      if (pieces.Find(way.From) != pieces.Find(way.To))
      {
        pieces.Merge(way.From, way.To);
        links.emplace_back(way.From, way.To);
        --left;
      }
    }
  }
  SetLinks(graph, std::move(links));
  progress(1.0);
  return islands;
}

} // namespace shape
