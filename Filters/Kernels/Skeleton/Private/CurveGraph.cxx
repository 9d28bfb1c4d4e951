#include "Skeleton/Private/CurveGraph.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace shape
{
namespace
{

/// Merges nodes. A merged node is at the centre of mass.
class Merger
{
public:
  explicit Merger(const CurveGraph& graph)
    : Graph(graph)
    , LinksOf(ListLinksOfNodes(graph))
    , Into(graph.Positions.size())
  {
    for (int i = 0; i < graph.Size(); ++i)
    {
      this->Into[i] = i;
    }
  }

  void Merge(double length)
  {
    for (int link = 0; link < static_cast<int>(this->Graph.Links.size()); ++link)
    {
      this->Push(link);
    }
    while (!this->Queue.empty() && std::get<0>(this->Queue.top()) < length)
    {
      const auto [measured, link] = this->Queue.top();
      this->Queue.pop();
      const auto [a, b] = this->Graph.Links[link];
      if (a != b && this->Length(link) == measured && !this->OnShortCycle(a, b))
      {
        this->MergeEnds(link);
      }
    }
  }

  CurveGraph Result() const
  {
    CurveGraph result;
    std::vector<int> number(this->Graph.Positions.size(), -1);
    for (int i = 0; i < this->Graph.Size(); ++i)
    {
      if (this->Into[i] == i)
      {
        number[i] = result.Size();
        result.Positions.push_back(this->Graph.Positions[i]);
        result.Masses.push_back(this->Graph.Masses[i]);
      }
    }
    for (int link = 0; link < static_cast<int>(this->Graph.Links.size()); ++link)
    {
      const auto [a, b] = this->Graph.Links[link];
      if (a >= 0)
      {
        result.Links.emplace_back(number[a], number[b]);
      }
    }
    return result;
  }

private:
  double Length(int link) const
  {
    const auto [a, b] = this->Graph.Links[link];
    return a < 0 ? -1.0 : (this->Graph.Positions[a] - this->Graph.Positions[b]).norm();
  }

  void Push(int link) { this->Queue.emplace(this->Length(link), link); }

  std::vector<int> Neighbours(int node) const
  {
    std::vector<int> found;
    for (const int link : this->LinksOf[node])
    {
      const auto [a, b] = this->Graph.Links[link];
      found.push_back(a == node ? b : a);
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  bool OnShortCycle(int a, int b) const
  {
    const std::vector<int> ofA = this->Neighbours(a), ofB = this->Neighbours(b);
    std::vector<int> common;
    std::set_intersection(
      ofA.begin(), ofA.end(), ofB.begin(), ofB.end(), std::back_inserter(common));
    return !common.empty() || std::count(ofA.begin(), ofA.end(), b) != 1;
  }

  void MergeEnds(int link)
  {
    const auto [a, b] = this->Graph.Links[link];
    const double mass = this->Graph.Masses[a] + this->Graph.Masses[b];
    this->Graph.Positions[a] = (this->Graph.Masses[a] * this->Graph.Positions[a] +
                                 this->Graph.Masses[b] * this->Graph.Positions[b]) /
      mass;
    this->Graph.Masses[a] = mass;
    this->Into[b] = a;
    this->Graph.Links[link] = { -1, -1 };
    std::vector<int>& links = this->LinksOf[a];
    links.erase(std::find(links.begin(), links.end(), link));
    for (const int other : this->LinksOf[b])
    {
      if (other != link)
      {
        auto& ends = this->Graph.Links[other];
        (ends.first == b ? ends.first : ends.second) = a;
        links.push_back(other);
      }
    }
    this->LinksOf[b].clear();
    for (const int other : links)
    {
      this->Push(other);
    }
  }

  using Entry = std::pair<double, int>;
  CurveGraph Graph;
  std::vector<std::vector<int>> LinksOf;
  std::vector<int> Into;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Queue;
};

} // namespace

int CountComponents(const CurveGraph& graph)
{
  DisjointSets sets(graph.Size());
  int components = graph.Size();
  for (const auto& [a, b] : graph.Links)
  {
    components -= sets.Find(a) != sets.Find(b);
    sets.Merge(a, b);
  }
  return components;
}

int CountCycles(const CurveGraph& graph)
{
  return static_cast<int>(graph.Links.size()) - graph.Size() + CountComponents(graph);
}

CurveGraph MergeShortLinks(const CurveGraph& graph, double length)
{
  Merger merger(graph);
  merger.Merge(length);
  return merger.Result();
}

CurveGraph RemoveNodes(const CurveGraph& graph, const std::vector<bool>& removed)
{
  CurveGraph result;
  std::vector<int> number(graph.Positions.size(), -1);
  for (int i = 0; i < graph.Size(); ++i)
  {
    if (!removed[i])
    {
      number[i] = result.Size();
      result.Positions.push_back(graph.Positions[i]);
      result.Masses.push_back(graph.Masses[i]);
    }
  }
  for (const auto& [a, b] : graph.Links)
  {
    if (!removed[a] && !removed[b])
    {
      result.Links.emplace_back(number[a], number[b]);
    }
  }
  return result;
}

std::vector<std::vector<int>> ListLinksOfNodes(const CurveGraph& graph)
{
  std::vector<std::vector<int>> links(graph.Positions.size());
  for (int i = 0; i < static_cast<int>(graph.Links.size()); ++i)
  {
    links[graph.Links[i].first].push_back(i);
    links[graph.Links[i].second].push_back(i);
  }
  return links;
}

std::vector<std::vector<int>> TracePaths(const CurveGraph& graph)
{
  const std::vector<std::vector<int>> linksOf = ListLinksOfNodes(graph);
  std::vector<std::vector<int>> paths;
  std::vector<bool> used(graph.Links.size(), false);
  const auto trace = [&](int node, int link)
  {
    std::vector<int> path = { node };
    while (link >= 0)
    {
      used[link] = true;
      const auto [a, b] = graph.Links[link];
      node = a == node ? b : a;
      path.push_back(node);
      link = -1;
      if (linksOf[node].size() == 2)
      {
        const int next = used[linksOf[node][0]] ? linksOf[node][1] : linksOf[node][0];
        link = used[next] ? -1 : next;
      }
    }
    paths.push_back(path);
  };
  // Cycles without a junction remain for the second round.
  for (const bool closed : { false, true })
  {
    for (int node = 0; node < graph.Size(); ++node)
    {
      for (const int link : linksOf[node])
      {
        if (!used[link] && (closed || linksOf[node].size() != 2))
        {
          trace(node, link);
        }
      }
      if (!closed && linksOf[node].empty())
      {
        paths.push_back({ node });
      }
    }
  }
  return paths;
}

} // namespace shape
