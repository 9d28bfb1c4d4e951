#include "Deform/Private/Protrusions.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace shape
{
namespace
{

/// A protrusion that ends at a saddle.
struct EndedProtrusion
{
  int Tip;                 ///< the rank of its last node
  std::vector<int> Saddle; ///< the ranks of the saddle
};

/// The join tree of the arrival times, pruned while it is built.
class JoinTree
{
public:
  JoinTree(const FrontSweep& sweep, double minimum)
    : Sweep(sweep)
    , Minimum(minimum)
    , Components(static_cast<int>(sweep.Nodes.size()))
    , SegmentOf(sweep.Nodes.size(), -1)
    , Segments(static_cast<int>(sweep.Nodes.size()))
  {
  }

  /// Adds connected ranks with one arrival time, which is earlier than that of all ranks added so
  /// far. They are linked to some of these.
  void Add(const std::vector<int>& zone, const std::vector<int>& linked)
  {
    const int rank = zone.back();
    std::set<int> roots;
    for (const int other : linked)
    {
      roots.insert(this->Components.Find(other));
    }
    // Those that are protrusions here, and the component that reaches farthest.
    std::vector<int> longOnes;
    int farthest = -1;
    for (const int root : roots)
    {
      const int tip = this->Open[root].Tip;
      if (this->LengthFrom(tip, rank) >= this->Minimum)
      {
        longOnes.push_back(root);
      }
      farthest = farthest < 0 || tip > this->Open[farthest].Tip ? root : farthest;
    }
    OpenComponent merged{ rank, rank };
    if (farthest >= 0)
    {
      merged = this->Open[farthest];
    }
    if (longOnes.size() > 1)
    {
      merged.Segment = rank; // a segment begins below the saddle
    }
    for (const int root : roots)
    {
      const OpenComponent& own = this->Open[root];
      const bool isLong = std::find(longOnes.begin(), longOnes.end(), root) != longOnes.end();
      if (!isLong || (longOnes.size() > 1 && this->LengthFrom(own.Segment, rank) < this->Minimum))
      {
        this->Segments.Merge(own.Segment, merged.Segment);
      }
      else if (longOnes.size() > 1 && own.Segment == own.Tip)
      {
        this->Ended.push_back({ own.Tip, zone });
      }
      this->Components.Merge(root, rank);
      this->Open.erase(root);
    }
    for (const int own : zone)
    {
      this->Components.Merge(own, rank);
      this->SegmentOf[own] = merged.Segment;
    }
    this->Open[this->Components.Find(rank)] = merged;
  }

  const std::vector<EndedProtrusion>& Protrusions() const { return this->Ended; }

  /// Returns the segment of each rank that was added, named by its highest rank.
  std::vector<int> Finish()
  {
    // Components that meet the sources without having joined another one.
    int largest = -1;
    for (const auto& [root, own] : this->Open)
    {
      largest = largest < 0 || own.Tip > this->Open[largest].Tip ? root : largest;
    }
    for (const auto& [root, own] : this->Open)
    {
      if (this->LengthFrom(own.Tip, 0) < this->Minimum)
      {
        this->Segments.Merge(own.Segment, this->Open[largest].Segment);
      }
    }
    std::vector<int> segments(this->SegmentOf.size(), -1);
    std::map<int, int> highest; // rank of each set of joined segments
    for (int rank = static_cast<int>(segments.size()) - 1; rank >= this->Sweep.Sources; --rank)
    {
      segments[rank] =
        highest.insert({ this->Segments.Find(this->SegmentOf[rank]), rank }).first->second;
    }
    return segments;
  }

private:
  struct OpenComponent
  {
    int Tip;     ///< its highest rank
    int Segment; ///< the rank at which its lowest segment begins
  };

  double LengthFrom(int top, int rank) const
  {
    return this->Sweep.Arrivals[top] - this->Sweep.Arrivals[rank];
  }

  const FrontSweep& Sweep;
  double Minimum;
  DisjointSets Components;           ///< of ranks
  std::map<int, OpenComponent> Open; ///< by the root of their set
  std::vector<int> SegmentOf;        ///< of ranks; a segment is named by its first rank
  DisjointSets Segments;
  std::vector<EndedProtrusion> Ended;
};

/// Moves the end of a protrusion from the level of its saddle to the distance of the saddle from
/// its tip. Around a bump whose saddle is on one side, the level cuts the other sides part-way up.
void GrowAroundTip(const Graph& graph, const FrontSweep& sweep, const EndedProtrusion& protrusion,
  std::vector<int>& segments)
{
  const int own = segments[protrusion.Tip], below = segments[protrusion.Saddle.front()];
  Eigen::VectorXd distances =
    Eigen::VectorXd::Constant(graph.Size(), std::numeric_limits<double>::infinity());
  std::vector<int> reached;
  double radius = 0.0;
  RunDijkstra(
    graph, { { sweep.Nodes[protrusion.Tip] }, Eigen::VectorXd::Zero(1) }, distances,
    [&](double distance, int link)
    {
      const int segment = segments[sweep.Ranks[graph.Neighbours[link]]];
      return segment == own || segment == below ? distance + graph.Lengths[link]
                                                : std::numeric_limits<double>::infinity();
    },
    [](int, int) {},
    [&](int node)
    {
      const int rank = sweep.Ranks[node];
      radius = distances(node);
      reached.push_back(rank);
      return std::find(protrusion.Saddle.begin(), protrusion.Saddle.end(), rank) !=
        protrusion.Saddle.end();
    });
  for (const int rank : reached)
  {
    segments[rank] = distances(sweep.Nodes[rank]) < radius ? own : segments[rank];
  }
}

} // namespace

/// Nodes that the front reaches at the same time are added together: on a regular grid there are
/// many, and their order must not decide to which of two protrusions a saddle belongs.
Eigen::VectorXi FindProtrusions(const Graph& graph, const FrontSweep& sweep, double minimum)
{
  const int n = graph.Size();
  JoinTree tree(sweep, minimum);
  for (int end = n, begin = n; end > sweep.Sources; end = begin)
  {
    while (begin > sweep.Sources && sweep.Arrivals[begin - 1] == sweep.Arrivals[end - 1])
    {
      --begin;
    }
    std::vector<char> isAdded(end - begin, 0);
    for (int first = begin; first < end; ++first)
    {
      std::vector<int> zone, later;
      if (isAdded[first - begin] == 0)
      {
        zone.push_back(first);
        isAdded[first - begin] = 1;
      }
      for (std::size_t i = 0; i < zone.size(); ++i)
      {
        const int node = sweep.Nodes[zone[i]];
        for (int k = graph.First[node]; k < graph.First[node + 1]; ++k)
        {
          const int other = sweep.Ranks[graph.Neighbours[k]];
          if (other >= end)
          {
            later.push_back(other);
          }
          else if (other >= begin && isAdded[other - begin] == 0)
          {
            isAdded[other - begin] = 1;
            zone.push_back(other);
          }
        }
      }
      if (!zone.empty())
      {
        tree.Add(zone, later);
      }
    }
  }
  std::vector<int> segments = tree.Finish();
  for (const EndedProtrusion& protrusion : tree.Protrusions())
  {
    GrowAroundTip(graph, sweep, protrusion, segments);
  }
  // The base is the segment with the most nodes next to the sources.
  std::map<int, int> touches;
  for (int rank = 0; rank < sweep.Sources; ++rank)
  {
    const int node = sweep.Nodes[rank];
    for (int k = graph.First[node]; k < graph.First[node + 1]; ++k)
    {
      const int other = sweep.Ranks[graph.Neighbours[k]];
      if (other >= sweep.Sources)
      {
        ++touches[segments[other]];
      }
    }
  }
  const auto base = std::max_element(touches.begin(), touches.end(),
    [](const auto& a, const auto& b) { return a.second < b.second; });
  std::map<int, int> labelOf;
  if (base != touches.end())
  {
    labelOf[base->first] = 0;
  }
  Eigen::VectorXi labels = Eigen::VectorXi::Zero(n);
  for (int rank = n - 1; rank >= sweep.Sources; --rank)
  {
    const auto next = static_cast<int>(labelOf.size());
    labels(sweep.Nodes[rank]) = labelOf.insert({ segments[rank], next }).first->second;
  }
  return labels;
}

} // namespace shape
