#include "Deform/Private/MultiresolutionDeformation.h"

#include "Base/Parallel.h"
#include "Deform/Private/BlendedRows.h"
#include "Geometry/FitRotation.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <utility>

namespace shape
{

/// A base node and its distance.
struct MultiresolutionDeformation::Nearby
{
  double Distance;
  int Node;
  bool operator<(const Nearby& other) const
  {
    return this->Distance != other.Distance ? this->Distance < other.Distance
                                            : this->Node < other.Node;
  }
};

namespace
{

/// The number of base nodes that a node is blended from, if none is one of the denser sources.
/// k of section 2.3: about as many as a node and its ring.
constexpr double WantedNodes = 8.0;

/// Changes weights to make the weighted mean of offsets (k x 3) zero in the directions that they
/// span, or as close to zero as non-negative weights allow.
/// Moving least squares: weights times a linear function, chosen for a weighted mean of 0. Equation
/// 5 then reproduces linear functions along the base. The limit keeps the weights positive.
void Tilt(const Eigen::MatrixXd& ways, Eigen::VectorXd& weights)
{
  const Eigen::Vector3d mean = ways.transpose() * weights / weights.sum();
  const Eigen::Matrix3d moments = ways.transpose() * weights.asDiagonal() * ways / weights.sum();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments - mean * mean.transpose());
  Eigen::Vector3d tilt = Eigen::Vector3d::Zero();
  constexpr double spread = 0.1; // of the largest: on surfaces, not the direction of the normal
  int kept = 0;
  while (kept < 3 && axes.eigenvalues()(2 - kept) > spread * axes.eigenvalues()(2))
  {
    ++kept;
  }
  if (kept == 0)
  {
    return;
  }
  const Eigen::MatrixXd basis = axes.eigenvectors().rightCols(kept);
  const Eigen::MatrixXd inner = basis.transpose() * moments * basis;
  tilt = basis * inner.ldlt().solve(basis.transpose() * mean);
  const Eigen::VectorXd slopes = ways * tilt;
  constexpr double maximum = 0.9;
  const double steepest = slopes.maxCoeff();
  const double factor = steepest > maximum ? maximum / steepest : 1.0;
  weights.array() *= 1.0 - factor * slopes.array();
}

} // namespace

/// Section 2.3:
/// 1. Build the smooth base, which keeps the sources (BuildCoarseShape).
/// 2. Prepare its deformation by the method in full resolution.
/// 3. For each node of the shape, find the nearest connected base nodes and their weights (AddRow).
MultiresolutionDeformation::MultiresolutionDeformation(
  NodeProblem problem, int baseNodes, const NodeSolver& solve, const Progress& progress)
  : Problem(std::move(problem))
  , Coarse(BuildCoarseShape(
      this->Problem.Graph, this->Problem.Sources, baseNodes, progress.Part(0.0, 0.4)))
  , Sweep(SweepFront(this->Problem.Graph, this->Problem.Sources))
{
  PointGraph& graph = this->Coarse.Graph;
  const int n = graph.Size();
  this->Base = n;
  // The samples represent a strip beside the handle, as wide as the links of the base.
  this->IsSource.assign(n, 0);
  for (const int node : this->Coarse.Sources)
  {
    graph.Weights(node) *= graph.MeanLength / this->Problem.Graph.MeanLength;
    this->IsSource[node] = 1;
  }
  NodeProblem coarse{ graph, this->Coarse.Sources, Eigen::VectorXd::Zero(n),
    Eigen::VectorXd::Zero(n), this->Problem.Front };
  coarse.Curves = this->Problem.Curves;
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(n);
  for (int i = 0; i < this->Problem.Graph.Size(); ++i)
  {
    const int node = this->Coarse.BaseOf[i];
    // Parameters of a base node are the means over the nodes merged into it.
    coarse.Powers(node) += this->Problem.Powers(i);
    coarse.Scales(node) += this->Problem.Scales(i);
    ++counts(node);
  }
  coarse.Powers.array() /= counts.array();
  coarse.Scales.array() /= counts.array();
  const FrontSweep sweep = SweepFront(graph, this->Coarse.Sources);
  this->Inner = solve(std::move(coarse), progress.Part(0.4, 0.7));
  this->Empty = this->Inner->EmptyBands();
  this->Zero = this->Inner->ZeroWeights();
  this->Streamed = this->Inner->IsStreamed();

  this->FindAround();
  double full = 0.0;
  for (int i = 0; i < n; ++i)
  {
    full += this->IsSource[i] ? 0.0 : graph.Weights(i);
  }
  full /= std::max<double>(1.0, n - static_cast<double>(this->Coarse.Sources.size()));
  const auto all = static_cast<int>(this->Sweep.Nodes.size());
  this->First = { 0 };
  double reach = 0.0;
  for (int rank = this->Sweep.Sources; rank < all; ++rank)
  {
    if (rank % 1024 == 0)
    {
      progress(0.7 + 0.3 * rank / all);
    }
    this->AddRow(this->Sweep.Nodes[rank], full);
    for (std::size_t k = this->First.back(); k < this->Columns.size(); ++k)
    {
      // The maximum so far: Move needs the base up to there for all ranks before.
      reach = std::max(reach, sweep.Arrivals[sweep.Ranks[this->Columns[k]]]);
    }
    this->Reaches.push_back(reach);
    this->First.push_back(this->Columns.size());
  }
  this->Around.clear();
  progress(1.0);
}

void MultiresolutionDeformation::FindAround()
{
  // Connected nodes only: nodes that are near in space, but on another sheet, must not be blended.
  // Three rings usually contain the nearest 8.
  constexpr int rings = 3;
  constexpr std::size_t enough = 64;
  const PointGraph& graph = this->Coarse.Graph;
  std::vector<int> seenBy(graph.Size(), -1);
  this->Around.resize(graph.Size());
  for (int node = 0; node < graph.Size(); ++node)
  {
    std::vector<int>& found = this->Around[node];
    found = { node };
    seenBy[node] = node;
    std::size_t begin = 0;
    for (int ring = 0; ring < rings && found.size() < enough; ++ring)
    {
      const std::size_t end = found.size();
      for (; begin < end; ++begin)
      {
        for (int k = graph.First[found[begin]]; k < graph.First[found[begin] + 1]; ++k)
        {
          const int other = graph.Neighbours[k];
          if (seenBy[other] != node)
          {
            seenBy[other] = node;
            found.push_back(other);
          }
        }
      }
    }
  }
}

std::vector<MultiresolutionDeformation::Nearby> MultiresolutionDeformation::FindNearby(
  int node, double full) const
{
  const PointGraph& graph = this->Coarse.Graph;
  const Eigen::RowVector3d position = this->Problem.Graph.Positions.row(node);
  const std::vector<int>& found = this->Around[this->Coarse.BaseOf[node]];
  std::vector<Nearby> nearest;
  nearest.reserve(found.size());
  for (const int other : found)
  {
    nearest.push_back({ (graph.Positions.row(other) - position).norm(), other });
  }
  std::sort(nearest.begin(), nearest.end());
  // Samples of the handle may be denser than the base: use as many as represent the same area.
  double sum = 0.0;
  std::size_t count = 0;
  while (count < nearest.size() && sum < WantedNodes)
  {
    const double weight = graph.Weights(nearest[count].Node);
    sum += full > 0.0 ? std::min(weight / full, 1.0) : 1.0;
    ++count;
  }
  // One more, where the weights become 0.
  nearest.resize(std::min(count + 1, nearest.size()));
  return nearest;
}

void MultiresolutionDeformation::AddRow(int node, double full)
{
  const PointGraph& graph = this->Coarse.Graph;
  const std::vector<Nearby> nearest = this->FindNearby(node, full);
  const auto count = static_cast<Eigen::Index>(nearest.size());
  Eigen::MatrixXd ways(count, 3);
  Eigen::VectorXd weights(count);
  // Near the sources only these have weights, which grow towards them: there the shape is exact.
  const double arrival = this->Sweep.Arrivals[this->Sweep.Ranks[node]];
  const double beyond = 1.0 - EvaluateSmoothFalloff(arrival, graph.MeanLength);
  // Slightly larger than the last distance, so that the weights are not all 0 if all distances are
  // equal.
  const double radius = std::max(1.001 * nearest.back().Distance, 1e-6 * graph.MeanLength);
  for (Eigen::Index k = 0; k < count; ++k)
  {
    ways.row(k) = graph.Positions.row(nearest[k].Node) - this->Problem.Graph.Positions.row(node);
    const double distance = nearest[k].Distance / graph.MeanLength;
    weights(k) = graph.Weights(nearest[k].Node) *
      EvaluateSmoothFalloff(nearest[k].Distance, radius) *
      (this->IsSource[nearest[k].Node] ? 1.0 + 1.0 / (distance * distance + 1e-6) : beyond);
  }
  if (weights.sum() > 0.0)
  {
    Tilt(ways, weights);
  }
  else
  {
    weights(0) = 1.0;
  }
  const double largest = weights.maxCoeff();
  double sum = 0.0;
  for (Eigen::Index k = 0; k < count; ++k)
  {
    const auto weight = static_cast<float>(weights(k) / largest);
    if (weight > 0.0F)
    {
      this->Columns.push_back(nearest[k].Node);
      this->Weights.push_back(weight);
      sum += static_cast<double>(weight);
    }
  }
  this->Sums.push_back(sum);
}

NodeTransforms MultiresolutionDeformation::Move(
  const NodeTransforms& sources, double reach, const Progress& progress) const
{
  const auto n = static_cast<int>(this->Sweep.Nodes.size());
  const int first = this->Sweep.Sources;
  const auto last =
    std::upper_bound(this->Sweep.Arrivals.begin() + first, this->Sweep.Arrivals.end(), reach);
  const auto count = static_cast<int>(last - this->Sweep.Arrivals.begin()) - first;
  const double baseReach = count > 0 ? this->Reaches[count - 1] : 0.0;
  const NodeTransforms base = this->Inner->Move(sources, baseReach, progress.Part(0.0, 0.5));

  const Eigen::MatrixXd& positions = this->Coarse.Graph.Positions;
  const Eigen::Vector3d centre =
    0.5 * (positions.colwise().minCoeff() + positions.colwise().maxCoeff()).transpose();
  const Eigen::Vector3d shift = sources.Shifts.rowwise().mean();
  // The 15 numbers of a base node are contiguous.
  std::vector<std::array<double, MotionSize>> numbers(positions.rows());
  for (Eigen::Index j = 0; j < positions.rows(); ++j)
  {
    const Eigen::Vector3d rest = positions.row(j).transpose() - centre;
    Eigen::Map<Eigen::Vector3d>(numbers[j].data()) = rest + (base.Shifts.col(j) - shift);
    Eigen::Map<Eigen::Vector3d>(numbers[j].data() + 3) = base.Rotations[j] * rest;
    Eigen::Map<Eigen::Matrix3d>(numbers[j].data() + 6) = base.Rotations[j];
  }
  NodeTransforms motions{ Eigen::MatrixXd::Zero(3, n),
    std::vector<Eigen::Matrix3d>(n, Eigen::Matrix3d::Identity()) };
  for (int rank = 0; rank < first; ++rank)
  {
    motions.Shifts.col(this->Sweep.Nodes[rank]) = sources.Shifts.col(rank);
    motions.Rotations[this->Sweep.Nodes[rank]] = sources.Rotations[rank];
  }
  ParallelFor(
    count, 256,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        std::array<double, MotionSize> sums{};
        for (std::size_t k = this->First[i]; k < this->First[i + 1]; ++k)
        {
          const double weight = this->Weights[k];
          const auto& from = numbers[this->Columns[k]];
          for (int c = 0; c < MotionSize; ++c)
          {
            sums[c] += weight * from[c];
          }
        }
        BlendedTransform blend;
        blend.Position = Eigen::Map<const Eigen::Vector3d>(sums.data()) / this->Sums[i];
        blend.Turned = Eigen::Map<const Eigen::Vector3d>(sums.data() + 3) / this->Sums[i];
        blend.Rotation = Eigen::Map<const Eigen::Matrix3d>(sums.data() + 6) / this->Sums[i];
        const int node = this->Sweep.Nodes[first + i];
        const Eigen::Vector3d rest = this->Problem.Graph.Positions.row(node).transpose() - centre;
        motions.Shifts.col(node) = blend.Apply(rest, this->Problem.Scales(node)) - rest + shift;
        motions.Rotations[node] = FitBlendedRotation(blend.Rotation);
      }
    },
    progress.Part(0.5, 1.0));
  return motions;
}

} // namespace shape
