#include "Deform/Private/FrontDeformation.h"

#include "Base/Parallel.h"
#include "Geometry/FitRotation.h"

#include <algorithm>
#include <utility>

namespace shape
{

/// Section 2.1 in two passes. The weights of equation 9 depend on the shape at rest only and are
/// computed in parallel; Move then follows the front.
FrontDeformation::FrontDeformation(NodeProblem problem, const Progress& progress)
  : Problem(std::move(problem))
  , Sweep(SweepFront(this->Problem.Graph, this->Problem.Sources, progress.Part(0.0, 0.2)))
  , Front(this->Problem.Graph, this->Sweep, this->Problem.Powers, this->Problem.Front)
{
  const Eigen::MatrixXd& positions = this->Problem.Graph.Positions;
  const Eigen::RowVector3d centre =
    0.5 * (positions.colwise().minCoeff() + positions.colwise().maxCoeff());
  this->Rests = (positions.rowwise() - centre)(this->Sweep.Nodes, Eigen::all).transpose();
  this->Empty = this->Front.EmptyBands();
  this->KeepWeights(progress.Part(0.2, 1.0));
}

void FrontDeformation::KeepWeights(const Progress& progress)
{
  const int sources = this->Sweep.Sources;
  const int count = static_cast<int>(this->Sweep.Nodes.size()) - sources;
  int widest = 0;
  for (int rank = sources; rank < sources + count; ++rank)
  {
    const int width = this->Front.End(rank) - this->Front.Begin(rank);
    this->Rows.Add(this->Front.Begin(rank), width);
    widest = std::max(widest, width);
  }
  // Section 2.3: storage grows as N log^2 N. Weights that do not fit are computed again in each
  // pass.
  this->Streamed = this->Rows.Size() > this->Problem.MaximumWeights;
  if (!this->Streamed)
  {
    this->Rows.Allocate();
  }
  std::vector<char> none(count, 0);
  ParallelFor(
    count, 64,
    [&](int begin, int end)
    {
      std::vector<float> row(widest);
      for (int i = begin; i < end; ++i)
      {
        none[i] = !this->Front.Row(sources + i, row.data());
        if (!this->Streamed)
        {
          this->Rows.Set(i, row.data());
        }
      }
    },
    progress);
  this->Zero = static_cast<int>(std::count(none.begin(), none.end(), 1));
}

BlendedTransform FrontDeformation::Blend(
  int rank, const SampleTransforms& samples, BlendedRows& one, std::vector<float>& weights) const
{
  if (!this->Streamed)
  {
    return this->Rows.Blend(rank - this->Sweep.Sources, samples);
  }
  const int begin = this->Front.Begin(rank), count = this->Front.End(rank) - begin;
  weights.resize(count);
  this->Front.Row(rank, weights.data());
  one.Clear();
  one.Add(begin, count);
  one.Allocate();
  one.Set(0, weights.data());
  return one.Blend(0, samples);
}

/// One pass in the order of arrival: the band of a node is already deformed when its turn comes.
NodeTransforms FrontDeformation::Move(
  const NodeTransforms& sources, double reach, const Progress& progress) const
{
  const auto n = static_cast<int>(this->Sweep.Nodes.size());
  // Relative to the centre of the shape and of the moved sources, so a translation costs no digits.
  const Eigen::Vector3d shift = sources.Shifts.rowwise().mean();
  NodeTransforms motions{ Eigen::MatrixXd::Zero(3, n),
    std::vector<Eigen::Matrix3d>(n, Eigen::Matrix3d::Identity()) };
  SampleTransforms samples(n);
  BlendedRows one;
  std::vector<float> weights;
  for (int rank = 0; rank < n && this->Sweep.Arrivals[rank] <= reach; ++rank)
  {
    if (rank % 256 == 0)
    {
      progress(static_cast<double>(rank) / n);
    }
    const int node = this->Sweep.Nodes[rank];
    const Eigen::Vector3d rest = this->Rests.col(rank);
    Eigen::Vector3d position;
    Eigen::Matrix3d& rotation = motions.Rotations[node];
    if (rank < this->Sweep.Sources)
    {
      position = rest + (sources.Shifts.col(rank) - shift);
      rotation = sources.Rotations[rank];
      motions.Shifts.col(node) = sources.Shifts.col(rank);
    }
    else
    {
      // Equation 5, with the upwind band as Omega.
      const BlendedTransform blend = this->Blend(rank, samples, one, weights);
      position = blend.Apply(rest, this->Problem.Scales(node));
      // The normalised linear blend of frames of section 2.1.
      rotation = FitBlendedRotation(blend.Rotation);
      motions.Shifts.col(node) = position - rest + shift;
    }
    samples.Set(rank, rest, position, rotation);
  }
  progress(1.0);
  return motions;
}

} // namespace shape
