#include "Deform/Private/BoundaryIntegral.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Deform/Private/BlendedRows.h"
#include "Geometry/FitRotation.h"

#include <array>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

/// The weighted sum of the numbers of samples (see SampleTransforms), and the sum of the weights.
struct MotionSum
{
  std::array<double, MotionSize> Numbers{};
  double Weight = 0.0;

  void Add(double weight, const double* numbers)
  {
    for (int c = 0; c < MotionSize; ++c)
    {
      this->Numbers[c] += weight * numbers[c];
    }
    this->Weight += weight;
  }

  BlendedTransform Mean() const
  {
    BlendedTransform mean;
    const double* numbers = this->Numbers.data();
    mean.Position = Eigen::Map<const Eigen::Vector3d>(numbers) / this->Weight;
    mean.Turned = Eigen::Map<const Eigen::Vector3d>(numbers + 3) / this->Weight;
    mean.Rotation = Eigen::Map<const Eigen::Matrix3d>(numbers + 6) / this->Weight;
    return mean;
  }
};

} // namespace

SegmentIntegrals IntegrateInverseSquare(
  const Eigen::Vector3d& first, const Eigen::Vector3d& last, double epsilon)
{
  const double length = (last - first).norm(), half = 0.5 * length;
  const Eigen::Vector3d along = (last - first) / length, centre = 0.5 * (first + last);
  const double m = -centre.dot(along);
  const double height2 = (centre + m * along).squaredNorm() + epsilon, height = std::sqrt(height2);
  // The angle between the directions to the ends is accurate if it is small, too; a difference of
  // two arc tangents is not.
  const double j0 = std::atan2(height * length, height2 + (m - half) * (m + half)) / height;
  // The quotient of the larger distance and the smaller one: no digits are lost near an end.
  const double nearer = half - std::abs(m);
  const double logarithm =
    0.5 * std::log1p(2.0 * std::abs(m) * length / (nearer * nearer + height2));
  const double j1 = m * j0 - std::copysign(logarithm, m);
  const double j2 = length + 2.0 * m * j1 - (m * m + height2) * j0;
  const double share = j1 / length;
  return { (0.5 * j0 - share) / length, (0.5 * j0 + share) / length,
    (0.25 * j0 - j2 / (length * length)) / length };
}

BoundaryIntegral::BoundaryIntegral(NodeProblem problem, const Progress& progress)
  : Problem(std::move(problem))
  , Sweep(SweepFront(this->Problem.Graph, this->Problem.Sources, progress))
{
  if (this->Problem.Curves.Segments.rows() == 0)
  {
    throw InvalidInput("the handle has no curves along which equation 5 could be integrated; join "
                       "its points by lines, or turn IntegrateCurves off");
  }
  if ((this->Problem.Powers.array() != 2.0).any())
  {
    throw InvalidInput(
      "integrals along curves have a closed form for rigidity 1 only; set Rigidity "
      "to 1 and RigidityBy to Uniform, without an array, or turn IntegrateCurves "
      "off");
  }
  const Eigen::MatrixXd& positions = this->Problem.Graph.Positions;
  // Relative to the centre, a shape far from the origin loses no digits.
  const Eigen::RowVector3d centre =
    0.5 * (positions.colwise().minCoeff() + positions.colwise().maxCoeff());
  this->Rests = (positions.rowwise() - centre)(this->Sweep.Nodes, Eigen::all).transpose();
  // The epsilon of EvaluateInverseDistanceWeight, whose distances are in mean links.
  this->Epsilon = 1e-6 * this->Problem.Graph.MeanLength * this->Problem.Graph.MeanLength;
}

NodeTransforms BoundaryIntegral::Move(
  const NodeTransforms& sources, double reach, const Progress& progress) const
{
  const auto n = static_cast<int>(this->Sweep.Nodes.size());
  const int first = this->Sweep.Sources;
  const PointGraph& graph = this->Problem.Graph;
  const SourceCurves& curves = this->Problem.Curves;
  const Eigen::Vector3d shift = sources.Shifts.rowwise().mean();
  NodeTransforms motions{ Eigen::MatrixXd::Zero(3, n),
    std::vector<Eigen::Matrix3d>(n, Eigen::Matrix3d::Identity()) };
  std::vector<std::array<double, MotionSize>> numbers(first);
  for (int j = 0; j < first; ++j)
  {
    const int node = this->Sweep.Nodes[j];
    motions.Shifts.col(node) = sources.Shifts.col(j);
    motions.Rotations[node] = sources.Rotations[j];
    const Eigen::Vector3d rest = this->Rests.col(j);
    Eigen::Map<Eigen::Vector3d>(numbers[j].data()) = rest + (sources.Shifts.col(j) - shift);
    Eigen::Map<Eigen::Vector3d>(numbers[j].data() + 3) = sources.Rotations[j] * rest;
    Eigen::Map<Eigen::Matrix3d>(numbers[j].data() + 6) = sources.Rotations[j];
  }
  // (R_b - R_a) (b - a) of each segment.
  Eigen::MatrixXd bends(3, curves.Segments.rows());
  for (Eigen::Index i = 0; i < bends.cols(); ++i)
  {
    const int a = curves.Segments(i, 0), b = curves.Segments(i, 1);
    bends.col(i) =
      (sources.Rotations[b] - sources.Rotations[a]) * (this->Rests.col(b) - this->Rests.col(a));
  }
  const double width = CurveWidth * graph.MeanLength;
  const auto blend = [&](const Eigen::Vector3d& point)
  {
    MotionSum sum;
    Eigen::Vector3d bend = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < bends.cols(); ++i)
    {
      const int a = curves.Segments(i, 0), b = curves.Segments(i, 1);
      const Eigen::Vector3d from = this->Rests.col(a), to = this->Rests.col(b);
      const SegmentIntegrals integrals =
        IntegrateInverseSquare(from - point, to - point, this->Epsilon);
      const double strip = width * (to - from).norm();
      sum.Add(strip * integrals.First, numbers[a].data());
      sum.Add(strip * integrals.Last, numbers[b].data());
      bend += strip * integrals.Inner * bends.col(i);
    }
    for (int j = 0; j < first; ++j)
    {
      if (curves.OtherShares(j) > 0.0)
      {
        // The weight of equation 5 in the units of the integrals.
        const double distance = (this->Rests.col(j) - point).squaredNorm() + this->Epsilon;
        sum.Add(curves.OtherShares(j) * graph.Weights(this->Sweep.Nodes[j]) / distance,
          numbers[j].data());
      }
    }
    BlendedTransform mean = sum.Mean();
    mean.Turned -= bend / sum.Weight;
    return mean;
  };
  ParallelFor(
    n - first, 64,
    [&](int begin, int end)
    {
      for (int i = begin; i < end && this->Sweep.Arrivals[first + i] <= reach; ++i)
      {
        const int node = this->Sweep.Nodes[first + i];
        const Eigen::Vector3d rest = this->Rests.col(first + i);
        const BlendedTransform mean = blend(rest);
        motions.Shifts.col(node) = mean.Apply(rest, this->Problem.Scales(node)) - rest + shift;
        motions.Rotations[node] = FitBlendedRotation(mean.Rotation);
      }
    },
    progress);
  return motions;
}

} // namespace shape
