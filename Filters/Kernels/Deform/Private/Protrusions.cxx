#include "Deform/Private/Protrusions.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace shape
{
namespace
{

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

  /// Adds a rank, below all ranks added so far, that is linked to some of these.
  void Add(int rank, const std::vector<int>& linked)
  {
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
      this->Components.Merge(root, rank);
      this->Open.erase(root);
    }
    this->Open[this->Components.Find(rank)] = merged;
    this->SegmentOf[rank] = merged.Segment;
  }

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
};

} // namespace

Eigen::VectorXi FindProtrusions(const Graph& graph, const FrontSweep& sweep, double minimum)
{
  const int n = graph.Size();
  JoinTree tree(sweep, minimum);
  for (int rank = n - 1; rank >= sweep.Sources; --rank)
  {
    const int node = sweep.Nodes[rank];
    std::vector<int> later;
    for (int k = graph.First[node]; k < graph.First[node + 1]; ++k)
    {
      const int other = sweep.Ranks[graph.Neighbours[k]];
      if (other > rank)
      {
        later.push_back(other);
      }
    }
    tree.Add(rank, later);
  }
  const std::vector<int> segments = tree.Finish();
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
