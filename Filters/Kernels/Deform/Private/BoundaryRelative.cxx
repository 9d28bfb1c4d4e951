#include "Deform/Private/BoundaryRelative.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/FitRotation.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>

namespace shape
{

/// Equation 5 with Omega the handle: one row of weights for each node, over all sources.
BoundaryRelative::BoundaryRelative(NodeProblem problem, const Progress& progress)
  : Problem(std::move(problem))
  , Sweep(SweepFront(this->Problem.Graph, this->Problem.Sources, progress.Part(0.0, 0.1)))
{
  const Eigen::MatrixXd& positions = this->Problem.Graph.Positions;
  // Relative to the centre, a shape far from the origin loses no digits.
  const Eigen::RowVector3d centre =
    0.5 * (positions.colwise().minCoeff() + positions.colwise().maxCoeff());
  this->Rests = (positions.rowwise() - centre)(this->Sweep.Nodes, Eigen::all).transpose();
  const int sources = this->Sweep.Sources;
  const int count = static_cast<int>(this->Sweep.Nodes.size()) - sources;
  for (int i = 0; i < count; ++i)
  {
    this->Rows.Add(0, sources);
  }
  this->Streamed = this->Rows.Size() > this->Problem.MaximumWeights;
  if (this->Problem.Front.Distance == FrontDistance::Geodesic)
  {
    if (this->Streamed)
    {
      throw InvalidInput("there are too many geodesic distances between " +
        std::to_string(sources) + " points of the handle and " + std::to_string(count) +
        " points of the shape; use Euclidean distances, or turn Multiresolution on");
    }
    this->Geodesics.resize(sources, sources + count);
    ParallelFor(
      sources, 4,
      [&](int begin, int end)
      {
        for (int source = begin; source < end; ++source)
        {
          const FrontSweep from =
            SweepFront(this->Problem.Graph, { this->Problem.Sources[source] });
          for (int rank = 0; rank < sources + count; ++rank)
          {
            this->Geodesics(source, rank) =
              static_cast<float>(from.Arrivals[from.Ranks[this->Sweep.Nodes[rank]]]);
          }
        }
      },
      progress.Part(0.1, 0.6));
  }
  if (!this->Streamed)
  {
    this->Rows.Allocate();
  }
  std::atomic<int> zero{ 0 };
  ParallelFor(
    count, 64,
    [&](int begin, int end)
    {
      std::vector<float> row(sources);
      for (int i = begin; i < end; ++i)
      {
        zero += this->FindRow(sources + i, row.data()) ? 0 : 1;
        if (!this->Streamed)
        {
          this->Rows.Set(i, row.data());
        }
      }
    },
    progress.Part(0.6, 1.0));
  this->Zero = zero;
  this->Geodesics.resize(0, 0);
}

void BoundaryRelative::FindDistances(int rank, double* distances) const
{
  for (int j = 0; j < this->Sweep.Sources; ++j)
  {
    distances[j] = this->Geodesics.size() > 0 ? static_cast<double>(this->Geodesics(j, rank))
                                              : (this->Rests.col(j) - this->Rests.col(rank)).norm();
  }
}

bool BoundaryRelative::FindRow(int rank, float* weights) const
{
  const int sources = this->Sweep.Sources;
  std::vector<double> distances(sources), row(sources);
  this->FindDistances(rank, distances.data());
  const double power = this->Problem.Powers(this->Sweep.Nodes[rank]);
  double largest = 0.0;
  for (int j = 0; j < sources; ++j)
  {
    // Equation 4, times the length or area that the source represents, which corrects non-uniform
    // sampling. Distances are in mean links, so epsilon has no unit.
    row[j] = this->Problem.Graph.Weights(this->Sweep.Nodes[j]) *
      EvaluateInverseDistanceWeight(distances[j] / this->Problem.Graph.MeanLength, power);
    largest = std::max(largest, row[j]);
  }
  const bool some = largest > 0.0;
  // All weights underflow: the nearest source alone is the limit for large powers.
  if (!some)
  {
    std::fill(row.begin(), row.end(), 0.0);
    row[std::min_element(distances.begin(), distances.end()) - distances.begin()] = largest = 1.0;
  }
  for (int j = 0; j < sources; ++j)
  {
    // Only ratios matter; the largest weight becomes 1 so that floats neither overflow nor vanish.
    weights[j] = static_cast<float>(row[j] / largest);
  }
  return some;
}

NodeTransforms BoundaryRelative::Move(
  const NodeTransforms& sources, double reach, const Progress& progress) const
{
  const auto n = static_cast<int>(this->Sweep.Nodes.size());
  const int first = this->Sweep.Sources;
  const Eigen::Vector3d shift = sources.Shifts.rowwise().mean();
  NodeTransforms motions{ Eigen::MatrixXd::Zero(3, n),
    std::vector<Eigen::Matrix3d>(n, Eigen::Matrix3d::Identity()) };
  SampleTransforms samples(first);
  for (int j = 0; j < first; ++j)
  {
    const int node = this->Sweep.Nodes[j];
    motions.Shifts.col(node) = sources.Shifts.col(j);
    motions.Rotations[node] = sources.Rotations[j];
    const Eigen::Vector3d rest = this->Rests.col(j);
    samples.Set(j, rest, rest + (sources.Shifts.col(j) - shift), sources.Rotations[j]);
  }
  ParallelFor(
    n - first, 256,
    [&](int begin, int end)
    {
      BlendedRows one;
      one.Add(0, first);
      std::vector<float> weights(first);
      if (this->Streamed)
      {
        one.Allocate();
      }
      for (int i = begin; i < end && this->Sweep.Arrivals[first + i] <= reach; ++i)
      {
        if (this->Streamed)
        {
          this->FindRow(first + i, weights.data());
          one.Set(0, weights.data());
        }
        const BlendedTransform blend =
          this->Streamed ? one.Blend(0, samples) : this->Rows.Blend(i, samples);
        const int node = this->Sweep.Nodes[first + i];
        const Eigen::Vector3d rest = this->Rests.col(first + i);
        motions.Shifts.col(node) = blend.Apply(rest, this->Problem.Scales(node)) - rest + shift;
        motions.Rotations[node] = FitBlendedRotation(blend.Rotation);
      }
    },
    progress);
  return motions;
}

} // namespace shape
