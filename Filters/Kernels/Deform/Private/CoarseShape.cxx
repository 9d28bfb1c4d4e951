#include "Deform/Private/CoarseShape.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

/// The remaining nodes and their links. Order of calls: Round and Smooth, until few nodes remain,
/// then Finish.
class Merging
{
public:
  Merging(const PointGraph& graph, const std::vector<int>& kept)
    : Positions(graph.Positions)
    , Weights(graph.Weights)
    , Links(ListLinks(graph))
    , Into(graph.Size())
    , Kept(graph.Size(), 0)
    , Left(graph.Size())
  {
    for (int i = 0; i < graph.Size(); ++i)
    {
      this->Into[i] = i;
    }
    for (const int node : kept)
    {
      this->Kept[node] = 1;
    }
  }

  /// Collapses up to `most` links, and at most a quarter of the nodes, since the collapsed links of
  /// one round are not adjacent only while most nodes remain. Returns their number.
  int Round(int maximum)
  {
    std::vector<std::pair<double, std::pair<int, int>>> shortest;
    for (const auto& link : this->Links)
    {
      if (!this->Kept[link.first] || !this->Kept[link.second])
      {
        shortest.push_back(
          { (this->Positions.row(link.first) - this->Positions.row(link.second)).norm(), link });
      }
    }
    std::sort(shortest.begin(), shortest.end());
    // No node takes part in two collapses of a round: else clusters would grow from the shortest
    // link.
    maximum = std::min(maximum, this->Left / 4 + 1);
    std::vector<char> touched(this->Into.size(), 0);
    int merged = 0;
    for (const auto& [length, link] : shortest)
    {
      if (merged == maximum)
      {
        break;
      }
      auto [to, from] = link;
      if (touched[to] || touched[from])
      {
        continue;
      }
      if (this->Kept[from])
      {
        std::swap(to, from);
      }
      touched[to] = touched[from] = 1;
      this->Merge(from, to);
      ++merged;
    }
    this->Relink();
    this->Left -= merged;
    return merged;
  }

  /// A step inwards and a longer one outwards: this smooths without shrinkage.
  void Smooth()
  {
    // Taubin's lambda | mu smoothing: mu is slightly larger in magnitude than lambda, which keeps
    // low frequencies.
    for (const double step : { 0.5, -0.53 })
    {
      Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(this->Positions.rows(), 3);
      Eigen::VectorXd counts = Eigen::VectorXd::Zero(this->Positions.rows());
      for (const auto& [a, b] : this->Links)
      {
        sums.row(a) += this->Positions.row(b) - this->Positions.row(a);
        sums.row(b) += this->Positions.row(a) - this->Positions.row(b);
        ++counts(a);
        ++counts(b);
      }
      for (Eigen::Index i = 0; i < sums.rows(); ++i)
      {
        if (!this->Kept[i] && counts(i) > 0.0)
        {
          this->Positions.row(i) += step / counts(i) * sums.row(i);
        }
      }
    }
  }

  CoarseShape Finish(const std::vector<int>& kept)
  {
    CoarseShape base;
    std::vector<int> number(this->Into.size(), -1), left;
    for (int i = 0; i < static_cast<int>(this->Into.size()); ++i)
    {
      if (this->Into[i] == i)
      {
        number[i] = static_cast<int>(left.size());
        left.push_back(i);
      }
    }
    for (int i = 0; i < static_cast<int>(this->Into.size()); ++i)
    {
      base.BaseOf.push_back(number[this->End(i)]);
    }
    for (const int node : kept)
    {
      base.Sources.push_back(number[node]);
    }
    for (auto& [a, b] : this->Links)
    {
      a = number[a];
      b = number[b];
    }
    base.Graph.Positions = this->Positions(left, Eigen::all);
    base.Graph.Weights = this->Weights(left);
    SetLinks(base.Graph, std::move(this->Links));
    return base;
  }

private:
  int End(int node) const
  {
    while (this->Into[node] != node)
    {
      node = this->Into[node];
    }
    return node;
  }

  void Merge(int from, int to)
  {
    const double sum = this->Weights(from) + this->Weights(to);
    if (!this->Kept[to])
    {
      const double share = sum > 0.0 ? this->Weights(from) / sum : 0.5;
      this->Positions.row(to) += share * (this->Positions.row(from) - this->Positions.row(to));
      this->Weights(to) = sum;
    }
    this->Into[from] = to;
  }

  void Relink()
  {
    for (auto& [a, b] : this->Links)
    {
      a = this->Into[a];
      b = this->Into[b];
      if (b < a)
      {
        std::swap(a, b);
      }
    }
    std::sort(this->Links.begin(), this->Links.end());
    this->Links.erase(std::unique(this->Links.begin(), this->Links.end()), this->Links.end());
    this->Links.erase(std::remove_if(this->Links.begin(), this->Links.end(),
                        [](const auto& link) { return link.first == link.second; }),
      this->Links.end());
  }

  Eigen::MatrixXd Positions;
  Eigen::VectorXd Weights;
  std::vector<std::pair<int, int>> Links;
  std::vector<int> Into; ///< what a node was merged into, or itself
  std::vector<char> Kept;
  int Left;
};

} // namespace

/// Section 2.3: rounds of collapses and of smoothing, without a metric that preserves detail.
CoarseShape BuildCoarseShape(
  const PointGraph& graph, const std::vector<int>& kept, int count, const Progress& progress)
{
  Merging merging(graph, kept);
  const int all = graph.Size() - static_cast<int>(kept.size());
  for (int left = all; left > count;)
  {
    progress(static_cast<double>(all - left) / (all - count));
    const int merged = merging.Round(left - count);
    if (merged == 0)
    {
      break;
    }
    left -= merged;
    merging.Smooth();
  }
  CoarseShape base = merging.Finish(kept);
  // The upwind radius is a multiple of it: it must not be smaller than that of the fine shape.
  base.Graph.MeanLength = std::max(ComputeMeanLinkLength(base.Graph), graph.MeanLength);
  progress(1.0);
  return base;
}

} // namespace shape
