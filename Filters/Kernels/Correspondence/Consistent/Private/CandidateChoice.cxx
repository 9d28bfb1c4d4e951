#include "Correspondence/Consistent/Private/CandidateChoice.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"

#include <Eigen/Cholesky>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace shape
{
namespace
{

using Frames = std::vector<Eigen::MatrixXd>;

/// How much a squared disagreement of 1 counts, against the logarithm of the ratio of two errors.
constexpr double Strictness = 2.0;

Eigen::MatrixXd NearestRotation(const Eigen::MatrixXd& matrix)
{
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  return svd.matrixU() * svd.matrixV().transpose();
}

/// A candidate of a pair, and what it costs.
struct Choice
{
  int Map = -1;
  double Cost = std::numeric_limits<double>::infinity(), Disagreement = std::sqrt(2.0);
};

/// The sum that is minimised, and the moves that lower it.
class ChoiceSearch
{
public:
  ChoiceSearch(int shapes, const std::vector<CandidatePair>& pairs, Eigen::Index size)
    : Pairs(pairs)
    , Size(size)
    , At(shapes)
  {
    for (int p = 0; p < static_cast<int>(pairs.size()); ++p)
    {
      Small.emplace_back();
      for (const FunctionalMaps& map : pairs[p].Maps)
      {
        Small[p].push_back(
          { map.AToB.topLeftCorner(size, size), map.BToA.topLeftCorner(size, size) });
      }
      if (!pairs[p].Maps.empty())
      {
        this->At[pairs[p].A].push_back(p);
        this->At[pairs[p].B].push_back(p);
      }
    }
  }

  Choice Best(int pair, const Eigen::MatrixXd& ofA, const Eigen::MatrixXd& ofB) const
  {
    const double root = std::sqrt(static_cast<double>(this->Size));
    Choice best;
    for (int c = 0; c < static_cast<int>(this->Small[pair].size()); ++c)
    {
      const FunctionalMaps& map = this->Small[pair][c];
      const double disagreement =
        0.5 * ((map.AToB * ofA - ofB).norm() + (map.BToA * ofB - ofA).norm()) / root;
      const std::vector<double>& errors = this->Pairs[pair].Errors;
      const double cost =
        std::log(errors[c] / errors[0]) + Strictness * std::min(disagreement * disagreement, 2.0);
      if (cost < best.Cost)
      {
        best = { c, cost, disagreement };
      }
    }
    return best;
  }

  double Sum(const Frames& frames) const
  {
    double sum = 0.0;
    for (int p = 0; p < static_cast<int>(this->Pairs.size()); ++p)
    {
      sum += this->Small[p].empty()
        ? 0.0
        : this->Best(p, frames[this->Pairs[p].A], frames[this->Pairs[p].B]).Cost;
    }
    return sum;
  }

  double SumAt(int shape, const Eigen::MatrixXd& frame, const Frames& frames) const
  {
    double sum = 0.0;
    for (const int p : this->At[shape])
    {
      const bool isA = this->Pairs[p].A == shape;
      sum += isA ? this->Best(p, frame, frames[this->Pairs[p].B]).Cost
                 : this->Best(p, frames[this->Pairs[p].A], frame).Cost;
    }
    return sum;
  }

  /// The frame of the other shape of a pair.
  Eigen::MatrixXd Carried(int pair, int map, int from, const Frames& frames) const
  {
    const FunctionalMaps& maps = this->Small[pair][map];
    return NearestRotation((this->Pairs[pair].A == from ? maps.AToB : maps.BToA) * frames[from]);
  }

  /// The spanning tree of the pairs with the smallest keys, ordered from a root: the pair and the
  /// shape that it reaches.
  std::vector<std::pair<int, int>> SpanningTree(const Eigen::VectorXd& keys) const
  {
    const auto shapes = static_cast<int>(this->At.size());
    std::vector<int> order;
    for (int p = 0; p < static_cast<int>(this->Pairs.size()); ++p)
    {
      if (!this->Small[p].empty())
      {
        order.push_back(p);
      }
    }
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return keys(a) < keys(b); });
    DisjointSets sets(shapes);
    std::vector<std::vector<int>> branches(shapes);
    for (const int p : order)
    {
      if (sets.Find(this->Pairs[p].A) != sets.Find(this->Pairs[p].B))
      {
        sets.Merge(this->Pairs[p].A, this->Pairs[p].B);
        branches[this->Pairs[p].A].push_back(p);
        branches[this->Pairs[p].B].push_back(p);
      }
    }
    std::vector<std::pair<int, int>> tree;
    std::vector<int> open{ 0 };
    std::vector<bool> reached(shapes, false);
    reached[0] = true;
    for (std::size_t next = 0; next < open.size(); ++next)
    {
      for (const int p : branches[open[next]])
      {
        const int other = this->Pairs[p].A == open[next] ? this->Pairs[p].B : this->Pairs[p].A;
        if (!reached[other])
        {
          reached[other] = true;
          open.push_back(other);
          tree.emplace_back(p, other);
        }
      }
    }
    if (static_cast<int>(open.size()) < shapes)
    {
      throw InvalidInput("the maps do not connect all shapes: between some of them no landmarks "
                         "were found; leave out the shapes that differ most, or raise Neighbours");
    }
    return tree;
  }

  /// The frames along a tree, by the chosen maps. changed: only this step and those behind it.
  Frames AlongTree(const std::vector<std::pair<int, int>>& tree, const std::vector<int>& chosen,
    const Frames& before = {}, std::size_t changed = 0) const
  {
    Frames frames = before;
    std::vector<bool> moves(this->At.size(), before.empty());
    if (before.empty())
    {
      frames.assign(this->At.size(), Eigen::MatrixXd::Identity(this->Size, this->Size));
    }
    for (std::size_t t = changed; t < tree.size(); ++t)
    {
      const auto& [pair, to] = tree[t];
      const int from = this->Pairs[pair].A == to ? this->Pairs[pair].B : this->Pairs[pair].A;
      if (t == changed || moves[from])
      {
        moves[to] = true;
        frames[to] = this->Carried(pair, chosen[pair], from, frames);
      }
    }
    return frames;
  }

  const std::vector<CandidatePair>& Pairs;
  Eigen::Index Size;
  std::vector<std::vector<FunctionalMaps>> Small; ///< the first functions of the maps
  std::vector<std::vector<int>> At;               ///< for each shape, its pairs
};

/// Exchanges the maps of the tree's pairs, one after the other, while the sum decreases.
bool ExchangeOnTree(const ChoiceSearch& search, const std::vector<std::pair<int, int>>& tree,
  std::vector<int>& chosen, Frames& frames, const Progress& progress)
{
  bool improved = false;
  double sum = search.Sum(frames);
  for (std::size_t t = 0; t < tree.size(); ++t)
  {
    progress(static_cast<double>(t) / static_cast<double>(tree.size()));
    const int pair = tree[t].first;
    const int kept = chosen[pair];
    int best = kept;
    for (int c = 0; c < static_cast<int>(search.Small[pair].size()); ++c)
    {
      chosen[pair] = c;
      Frames other = c == kept ? Frames() : search.AlongTree(tree, chosen, frames, t);
      const double changed = other.empty() ? sum : search.Sum(other);
      if (changed < sum - 1e-9)
      {
        sum = changed;
        best = c;
      }
    }
    chosen[pair] = best;
    if (best != kept)
    {
      frames = search.AlongTree(tree, chosen, frames, t);
      improved = true;
    }
  }
  return improved;
}

/// Replaces the frame of one shape after the other by what one of its pairs says.
bool ReplaceFrames(const ChoiceSearch& search, Frames& frames, const Progress& progress)
{
  bool improved = false;
  for (int i = 0; i < static_cast<int>(frames.size()); ++i)
  {
    progress(static_cast<double>(i) / static_cast<double>(frames.size()));
    double sum = search.SumAt(i, frames[i], frames) - 1e-9;
    Eigen::MatrixXd best;
    for (const int p : search.At[i])
    {
      const int other = search.Pairs[p].A == i ? search.Pairs[p].B : search.Pairs[p].A;
      for (int c = 0; c < static_cast<int>(search.Small[p].size()); ++c)
      {
        const Eigen::MatrixXd frame = search.Carried(p, c, other, frames);
        const double changed = search.SumAt(i, frame, frames);
        if (changed < sum)
        {
          sum = changed;
          best = frame;
        }
      }
    }
    if (best.size() > 0)
    {
      frames[i] = best;
      improved = true;
    }
  }
  return improved;
}

} // namespace

CandidateChoice ChooseCandidates(
  int shapes, const std::vector<CandidatePair>& pairs, Eigen::Index k, const Progress& progress)
{
  const ChoiceSearch search(shapes, pairs, k);
  const auto count = static_cast<Eigen::Index>(pairs.size());
  CandidateChoice result;
  result.Chosen.assign(count, 0);
  Eigen::VectorXd keys(count);
  for (Eigen::Index p = 0; p < count; ++p)
  {
    const std::vector<double>& errors = pairs[p].Errors;
    keys(p) = errors.size() > 1 ? errors[0] / errors[1] : 0.0;
  }
  std::vector<std::pair<int, int>> tree = search.SpanningTree(keys);
  Frames frames = search.AlongTree(tree, result.Chosen);
  constexpr int rounds = 10; // of both moves; nearly always, one or two suffice
  for (int round = 0; round < rounds; ++round)
  {
    const Progress part = progress.Part(round / 10.0, (round + 1) / 10.0);
    const bool exchanged = ExchangeOnTree(search, tree, result.Chosen, frames, part.Part(0.0, 0.5));
    const bool replaced = ReplaceFrames(search, frames, part.Part(0.5, 1.0));
    result.Disagreements.resize(count);
    for (Eigen::Index p = 0; p < count; ++p)
    {
      const Choice best = search.Best(static_cast<int>(p), frames[pairs[p].A], frames[pairs[p].B]);
      result.Chosen[p] = best.Map;
      result.Disagreements(p) = best.Disagreement;
    }
    tree = search.SpanningTree(result.Disagreements);
    if (!exchanged && !replaced)
    {
      break;
    }
    frames = search.AlongTree(tree, result.Chosen);
  }
  result.Frames = frames;
  for (const auto& step : tree)
  {
    result.Tree.push_back(step.first);
  }
  progress(1.0);
  return result;
}

std::vector<Eigen::MatrixXd> AverageFrames(int shapes, const std::vector<CandidatePair>& pairs,
  const std::vector<FunctionalMaps>& maps, const Eigen::VectorXd& weights,
  const std::vector<int>& tree)
{
  const Eigen::Index size = maps.at(0).AToB.rows();
  Frames frames(shapes);
  for (const int p : tree)
  {
    Eigen::MatrixXd &ofA = frames[pairs[p].A], &ofB = frames[pairs[p].B];
    if (ofA.size() == 0 && ofB.size() == 0)
    {
      frames[0] = Eigen::MatrixXd::Identity(size, size);
    }
    (ofB.size() == 0 ? ofB : ofA) = ofB.size() == 0 ? maps[p].AToB * ofA : maps[p].BToA * ofB;
  }
  constexpr int rounds = 20; // from the tree's frames, only the mean of the errors is left
  for (int round = 0; round < rounds; ++round)
  {
    Frames sums(shapes, Eigen::MatrixXd::Zero(size, size));
    Eigen::VectorXd total = Eigen::VectorXd::Zero(shapes);
    for (std::size_t p = 0; p < pairs.size(); ++p)
    {
      const double weight = weights(static_cast<Eigen::Index>(p));
      if (weight > 0.0)
      {
        const auto& [a, b] = std::pair(pairs[p].A, pairs[p].B);
        sums[b] += weight * maps[p].AToB * frames[a];
        sums[a] += weight * maps[p].BToA * frames[b];
        total(a) += weight;
        total(b) += weight;
      }
    }
    // Half of the old frame keeps two shapes from changing places.
    Eigen::MatrixXd products = Eigen::MatrixXd::Zero(size, size);
    for (int i = 0; i < shapes; ++i)
    {
      frames[i] = 0.5 * (frames[i] + sums[i] / total(i));
      products += frames[i].transpose() * frames[i] / static_cast<double>(shapes);
    }
    const Eigen::LLT<Eigen::MatrixXd> factor(products);
    for (Eigen::MatrixXd& frame : frames)
    {
      frame = factor.matrixU().solve<Eigen::OnTheRight>(frame);
    }
  }
  return frames;
}

} // namespace shape
