#include "Correspondence/Transport/Coupling.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Correspondence/Landmarks/DistanceQuantiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr int FewestSamples = 4;

/// Nodes of a graph that are far from each other, and the distances of all nodes from them.
class SampledGraph
{
public:
  /// first: the nodes that are the first samples.
  SampledGraph(const PointGraph& graph, const std::string& name, int count,
    const std::vector<int>& first, const Progress& progress)
    : Graph(graph)
    , ToNearest(Eigen::VectorXd::Constant(graph.Size(), std::numeric_limits<double>::infinity()))
  {
    const int size = graph.Size();
    count = std::max(std::min(count, size), static_cast<int>(first.size()));
    if (size < FewestSamples)
    {
      throw InvalidInput(
        name + " has " + std::to_string(size) + " different points; give one with at least 4");
    }
    this->Distances.resize(size, count);
    for (int k = 0; k < count; ++k)
    {
      this->Add(k < static_cast<int>(first.size()) ? first[k] : this->FindNext(), name);
      progress(static_cast<double>(k + 1) / count);
    }
  }

  int Count() const { return static_cast<int>(this->Nodes.size()); }
  const PointGraph& Points() const { return this->Graph; }
  const std::vector<int>& Samples() const { return this->Nodes; }
  /// The distances of all nodes from the first samples: n x count.
  auto From(int count) const { return this->Distances.leftCols(count); }
  /// The distances between the first samples.
  Eigen::MatrixXd Between(int count) const
  {
    const Eigen::MatrixXd there = this->From(count)(this->First(count), Eigen::all);
    return 0.5 * (there + there.transpose());
  }
  /// The share of the shape that is nearest to each of the first samples. Each is positive.
  Eigen::VectorXd Weights(int count) const;
  /// For each of the first samples, the quantiles of its distances from all nodes: count x q.
  Eigen::MatrixXd Quantiles(int count) const;

private:
  std::vector<int> First(int count) const
  {
    return { this->Nodes.begin(), this->Nodes.begin() + count };
  }

  /// The node farthest from the samples. The first sample is the end of a long path.
  int FindNext() const
  {
    Eigen::Index next = 0;
    if (this->Nodes.empty())
    {
      const Eigen::RowVector3d centre = this->Graph.Positions.colwise().mean();
      (this->Graph.Positions.rowwise() - centre).rowwise().squaredNorm().maxCoeff(&next);
    }
    else
    {
      this->ToNearest.maxCoeff(&next);
    }
    return static_cast<int>(next);
  }

  void Add(int node, const std::string& name)
  {
    const auto k = static_cast<Eigen::Index>(this->Nodes.size());
    Eigen::VectorXd from =
      Eigen::VectorXd::Constant(this->Graph.Size(), std::numeric_limits<double>::infinity());
    LowerDistances(this->Graph, { { node }, Eigen::VectorXd::Zero(1) }, from);
    if (!from.allFinite())
    {
      throw InvalidInput(name +
        " is in several pieces that are not connected; couple one piece, "
        "or connect them");
    }
    this->Nodes.push_back(node);
    this->Distances.col(k) = from;
    this->ToNearest = this->ToNearest.cwiseMin(from);
  }

  const PointGraph& Graph;
  std::vector<int> Nodes;
  Eigen::MatrixXd Distances;
  Eigen::VectorXd ToNearest;
};

Eigen::VectorXd SampledGraph::Weights(int count) const
{
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(count);
  for (Eigen::Index node = 0; node < this->Distances.rows(); ++node)
  {
    Eigen::Index nearest = 0;
    this->Distances.row(node).head(count).minCoeff(&nearest);
    weights(nearest) += this->Graph.Weights(node);
  }
  // A sample whose elements are all degenerate still takes part.
  constexpr double little = 1e-3; // of the mean
  const double mean = weights.mean();
  weights =
    mean > 0.0 ? weights.cwiseMax(little * mean).eval() : Eigen::VectorXd::Ones(count).eval();
  return weights / weights.sum();
}

Eigen::MatrixXd SampledGraph::Quantiles(int count) const
{
  constexpr int levels = 32;
  return ComputeDistanceQuantiles(this->From(count), this->Graph.Weights, levels);
}

/// The squared differences of the rows: a x b.
Eigen::MatrixXd SquaredDifferences(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  Eigen::MatrixXd squares = -2.0 * a * b.transpose();
  squares.colwise() += a.rowwise().squaredNorm();
  squares.rowwise() += b.rowwise().squaredNorm().transpose();
  return squares.cwiseMax(0.0);
}

/// Two sampled shapes whose distances are in one unit.
struct SampledPair
{
  const SampledGraph &A, &B;
  double UnitOfA, UnitOfB; ///< the lengths that count as 1
  int Fixed;               ///< the first samples are pairs

  MetricSpaces Spaces(int countA, int countB) const
  {
    MetricSpaces spaces{ this->A.Between(countA) / this->UnitOfA,
      this->B.Between(countB) / this->UnitOfB, this->A.Weights(countA), this->B.Weights(countB) };
    Normalize(spaces, this->Fixed);
    return spaces;
  }
};

/// Samples of B as images of the first samples of A.
using Anchors = std::vector<std::pair<int, int>>;

/// What is compared of the first samples of both shapes, in one unit.
struct SampleLikeness
{
  Eigen::MatrixXd BetweenA, BetweenB; ///< the distances of the samples of a shape
  Eigen::MatrixXd Squares;            ///< the mean squared difference of the quantiles

  SampleLikeness(const SampledPair& pair, int countA, int countB)
    : BetweenA(pair.A.Between(countA) / pair.UnitOfA)
    , BetweenB(pair.B.Between(countB) / pair.UnitOfB)
  {
    const Eigen::MatrixXd a = pair.A.Quantiles(countA) / pair.UnitOfA,
                          b = pair.B.Quantiles(countB) / pair.UnitOfB;
    this->Squares = SquaredDifferences(a, b) / static_cast<double>(a.cols());
  }

  /// The logarithms of the similarity of samples: alike quantiles and distances from the anchors.
  Eigen::MatrixXd Relative(const Anchors& anchors, double longest) const
  {
    constexpr double deviation = 0.05; // of the longest distance
    Eigen::MatrixXd squares = this->Squares;
    for (const auto& [onA, onB] : anchors)
    {
      squares += SquaredDifferences(this->BetweenA.col(onA), this->BetweenB.col(onB));
    }
    return -0.5 / (deviation * deviation * longest * longest) * squares;
  }
};

/// Triples of B's samples whose distances, and whose quantiles, are most like those of A's first
/// three samples. They differ from each other in some sample by more than a quarter of the longest
/// distance.
std::vector<Anchors> FindAnchors(const SampleLikeness& likeness, int starts)
{
  constexpr int first = 3;
  constexpr int maximum = 40; // of B's samples; their triples are compared
  const Eigen::MatrixXd &a = likeness.BetweenA, &b = likeness.BetweenB, &alike = likeness.Squares;
  const int countB = std::min(maximum, static_cast<int>(b.rows()));
  struct Triple
  {
    double Cost;
    std::array<int, 3> Images;
  };
  std::vector<Triple> triples;
  const auto square = [](double x) { return x * x; };
  for (int i = 0; i < countB; ++i)
  {
    for (int j = 0; j < countB; ++j)
    {
      for (int k = 0; k < countB; ++k)
      {
        triples.push_back({ alike(0, i) + alike(1, j) + alike(2, k) + square(a(0, 1) - b(i, j)) +
            square(a(1, 2) - b(j, k)) + square(a(2, 0) - b(k, i)),
          { i, j, k } });
      }
    }
  }
  std::sort(triples.begin(), triples.end(),
    [](const Triple& one, const Triple& other)
    { return std::tie(one.Cost, one.Images) < std::tie(other.Cost, other.Images); });
  const double apart = 0.25 * b.topLeftCorner(countB, countB).maxCoeff();
  std::vector<Anchors> chosen;
  for (const Triple& triple : triples)
  {
    if (static_cast<int>(chosen.size()) == starts)
    {
      break;
    }
    const auto isNear = [&](const Anchors& other)
    {
      double farthest = 0.0;
      for (int k = 0; k < first; ++k)
      {
        farthest = std::max(farthest, b(triple.Images[k], other[k].second));
      }
      return farthest <= apart;
    };
    if (std::none_of(chosen.begin(), chosen.end(), isNear))
    {
      chosen.push_back(
        { { 0, triple.Images[0] }, { 1, triple.Images[1] }, { 2, triple.Images[2] } });
    }
  }
  return chosen;
}

/// The images of the nodes of `a` among those of `b`. masses: from A's samples to B's.
Eigen::VectorXi FindImages(const Eigen::MatrixXd& fromA, const Eigen::MatrixXd& fromB,
  const Eigen::MatrixXd& masses, const Progress& progress)
{
  // The square is expanded: what depends on x alone does not count.
  const Eigen::MatrixXd pull = masses * fromB.transpose();
  const Eigen::VectorXd own = fromB.cwiseAbs2() * masses.colwise().sum().transpose();
  Eigen::VectorXi images(fromA.rows());
  constexpr int grain = 64; // nodes
  ParallelFor(
    static_cast<int>(images.size()), grain,
    [&](int begin, int end)
    {
      const Eigen::MatrixXd gains = fromA.middleRows(begin, end - begin) * pull;
      for (int i = begin; i < end; ++i)
      {
        Eigen::Index image = 0;
        (own.transpose() - 2.0 * gains.row(i - begin)).minCoeff(&image);
        images(i) = static_cast<int>(image);
      }
    },
    progress);
  return images;
}

/// The images of all points, from those of the nodes.
Eigen::VectorXi AtPoints(
  const Eigen::VectorXi& images, const PointGraph& from, const PointGraph& to)
{
  Eigen::VectorXi ofPoints(from.NodeOf.size());
  for (Eigen::Index point = 0; point < ofPoints.size(); ++point)
  {
    ofPoints(point) = to.PointOf[images(from.NodeOf(point))];
  }
  return ofPoints;
}

/// The nodes of the landmarks. A pair is left out if one of its nodes is in an earlier pair.
Landmarks NodesOf(const Landmarks& landmarks, const PointGraph& a, const PointGraph& b)
{
  Landmarks nodes;
  for (std::size_t k = 0; k < landmarks.size(); ++k)
  {
    std::array<int, 2> pair{};
    for (const int side : { 0, 1 })
    {
      const PointGraph& graph = side == 0 ? a : b;
      const int point = landmarks[k][side];
      if (point < 0 || point >= graph.NodeOf.size())
      {
        throw InvalidInput("landmark " + std::to_string(k) + " is point " + std::to_string(point) +
          ", which the shape does not have; choose one of its " +
          std::to_string(graph.NodeOf.size()) + " points");
      }
      pair[side] = graph.NodeOf(point);
    }
    if (std::none_of(nodes.begin(), nodes.end(),
          [&](const auto& other) { return other[0] == pair[0] || other[1] == pair[1]; }))
    {
      nodes.push_back(pair);
    }
  }
  return nodes;
}

std::vector<int> Side(const Landmarks& nodes, int side)
{
  std::vector<int> result;
  for (const auto& pair : nodes)
  {
    result.push_back(pair[side]);
  }
  return result;
}

std::vector<int> PointsAt(const SampledGraph& graph)
{
  std::vector<int> points;
  for (const int node : graph.Samples())
  {
    points.push_back(graph.Points().PointOf[node]);
  }
  return points;
}

} // namespace

// 1. Sample both shapes.
// 2. Couple a quarter of the samples from each start.
// 3. Couple all samples from the best result.
// 4. Find the images of all points relative to the coupling.
ShapeCouplingResult CoupleShapes(const ShapeElements& a, const ShapeElements& b,
  const Landmarks& landmarks, const ShapeCouplingOptions& options, const Progress& progress)
{
  RequireOption(options.Samples >= FewestSamples, "Samples", options.Samples, "at least 4");
  RequireOption(options.Starts >= 1, "Starts", options.Starts, "at least 1");
  RequireCouplingOptions(options.Coupling);
  const BlasThreads one(false);
  const PointGraph graphA = BuildPointGraph(a), graphB = BuildPointGraph(b);
  const Landmarks nodes = NodesOf(landmarks, graphA, graphB);
  const auto fixed = static_cast<int>(nodes.size());
  const SampledGraph onA(graphA, "ShapeA", fixed + options.Samples, Side(nodes, 0),
    progress.Part(0.0, 0.1, "measuring distances")),
    onB(graphB, "ShapeB", fixed + options.Samples, Side(nodes, 1),
      progress.Part(0.1, 0.2, "measuring distances"));
  if (fixed >= std::min(onA.Count(), onB.Count()))
  {
    throw InvalidInput(
      "all points of a shape are landmarks; give fewer, or a shape with more points");
  }
  const auto meanOf = [](const SampledGraph& graph)
  {
    const Eigen::VectorXd weights = graph.Weights(graph.Count());
    return weights.dot(graph.Between(graph.Count()) * weights);
  };
  const double meanOfA = meanOf(onA), meanOfB = meanOf(onB);
  const SampledPair pair{ onA, onB, meanOfA, options.SameSize ? meanOfB : meanOfA, fixed };

  constexpr int fewest = 16; // samples of the starts
  const int few = fixed + std::max(options.Samples / 4, fewest);
  const int fewA = std::min(few, onA.Count()), fewB = std::min(few, onB.Count());
  Landmarks pinned;
  Anchors own;
  for (int k = 0; k < fixed; ++k)
  {
    pinned.push_back({ k, k });
    own.emplace_back(k, k);
  }
  MetricSpaces spaces = pair.Spaces(fewA, fewB);
  const double longest = std::max(onA.Between(onA.Count()).maxCoeff() / pair.UnitOfA,
    onB.Between(onB.Count()).maxCoeff() / pair.UnitOfB);
  const SampleLikeness likeness(pair, fewA, fewB);
  const std::vector<Anchors> starts =
    fixed > 0 ? std::vector<Anchors>{ own } : FindAnchors(likeness, options.Starts);
  EntropicCoupling best;
  best.Distortion = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < starts.size(); ++k)
  {
    const double share = 0.3 / static_cast<double>(starts.size()),
                 begin = 0.2 + share * static_cast<double>(k);
    try
    {
      EntropicCoupling coupling = SolveCoupling(spaces, likeness.Relative(starts[k], longest),
        pinned, options.Coupling, progress.Part(begin, begin + share, "coupling the samples"));
      if (coupling.Distortion < best.Distortion)
      {
        best = std::move(coupling);
      }
    }
    catch (const SolveFailure&)
    {
      if (k + 1 == starts.size() && best.Masses.size() == 0)
      {
        throw; // no start has converged
      }
    }
  }
  if (onA.Count() > fewA || onB.Count() > fewB)
  {
    spaces = pair.Spaces(onA.Count(), onB.Count());
    best = RefineCoupling(spaces, best.Masses, pinned, options.Coupling,
      progress.Part(0.5, 0.9, "coupling the samples"));
  }
  ShapeCouplingResult result;
  result.Distortion = best.Distortion * longest;
  result.Error = best.Error;
  const Eigen::MatrixXd fromA = onA.From(onA.Count()) / pair.UnitOfA,
                        fromB = onB.From(onB.Count()) / pair.UnitOfB;
  result.ImagesOfA = AtPoints(
    FindImages(fromA, fromB, best.Masses, progress.Part(0.9, 0.95)), onA.Points(), onB.Points());
  result.ImagesOfB =
    AtPoints(FindImages(fromB, fromA, best.Masses.transpose(), progress.Part(0.95, 1.0)),
      onB.Points(), onA.Points());
  result.Coupling = { PointsAt(onA), PointsAt(onB), std::move(spaces.WeightsA),
    std::move(spaces.WeightsB), std::move(best.Masses) };
  return result;
}

} // namespace shape
