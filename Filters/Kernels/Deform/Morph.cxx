#include "Deform/Morph.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/FitRotation.h"
#include "Geometry/RotationVector.h"
#include "Linear/SparseSolve.h"
#include "Mesh/Topology.h"
#include "Search/RowFinder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>

namespace shape
{

namespace
{

constexpr double FullTurn = 2.0 * M_PI;

/// A line, triangle or tetrahedron; Weight is the factor of its edges in the least squares.
struct MorphElement
{
  std::array<int, 4> Corners;
  int Count;
  double Weight;
};

/// Calls visit(a, b) with the corners of each edge, numbered from 0.
template <typename Visit>
void ForEachEdge(const MorphElement& element, const Visit& visit)
{
  for (int a = 0; a < element.Count; ++a)
  {
    for (int b = a + 1; b < element.Count; ++b)
    {
      visit(a, b);
    }
  }
}

Eigen::Vector3d EdgeOf(const MorphElement& element, int a, int b, const Eigen::MatrixXd& points)
{
  return (points.row(element.Corners[b]) - points.row(element.Corners[a])).transpose();
}

double SizeOf(const MorphElement& element, const Eigen::MatrixXd& points)
{
  const Eigen::Vector3d first = EdgeOf(element, 0, 1, points);
  if (element.Count == 2)
  {
    return first.norm();
  }
  const Eigen::Vector3d normal = first.cross(EdgeOf(element, 0, 2, points));
  return element.Count == 3 ? 0.5 * normal.norm()
                            : std::abs(normal.dot(EdgeOf(element, 0, 3, points))) / 6.0;
}

/// The size divided by the squared length of the longest edge, so that the sum over elements is
/// comparable with an integral of squared gradients. No weight is negative, unlike cotangents of
/// obtuse triangles. Elements without size get a small weight, which connects their points.
void AppendElements(const Eigen::MatrixXi& corners, const Eigen::MatrixXd& points,
  const std::vector<int>& first, std::vector<MorphElement>& elements)
{
  const std::size_t begin = elements.size();
  double sum = 0.0;
  for (Eigen::Index i = 0; i < corners.rows(); ++i)
  {
    MorphElement element = { {}, static_cast<int>(corners.cols()), 0.0 };
    for (int k = 0; k < element.Count; ++k)
    {
      element.Corners[k] = first[corners(i, k)];
    }
    double longest = 0.0;
    ForEachEdge(element,
      [&](int a, int b)
      { longest = std::max(longest, EdgeOf(element, a, b, points).squaredNorm()); });
    element.Weight = longest > 0.0 ? SizeOf(element, points) / longest : 0.0;
    sum += element.Weight;
    elements.push_back(element);
  }
  const double smallest = sum > 0.0 ? 1e-6 * sum / static_cast<double>(corners.rows()) : 1.0;
  for (std::size_t i = begin; i < elements.size(); ++i)
  {
    elements[i].Weight = std::max(elements[i].Weight, smallest);
  }
}

/// Returns the rotation vector of `rotation` that is nearest to `near`, if it differs from `near`
/// about as much as the rotations do. Around whole turns it may differ far more, since every
/// vector of a whole number of turns is the identity. Then the result is along `near`; what remains
/// of the rotation counts as a stretch.
Eigen::Vector3d FindTurn(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& near)
{
  constexpr double largestGrowth = 0.5 * M_PI; // of half a turn
  const Eigen::AngleAxisd smallest(rotation);
  const double along = smallest.axis().dot(near);
  const double turns = std::round((along - smallest.angle()) / FullTurn);
  const Eigen::Vector3d turn = (smallest.angle() + FullTurn * turns) * smallest.axis();
  const double length = near.norm();
  const double difference = Eigen::AngleAxisd(ToRotation(near).transpose() * rotation).angle();
  if (length <= M_PI || (turn - near).norm() <= largestGrowth * difference)
  {
    return turn;
  }
  const Eigen::Vector3d axis = near / length;
  const Eigen::Quaterniond quaternion(rotation);
  const double angle = 2.0 * std::atan2(quaternion.vec().dot(axis), quaternion.w());
  return (angle + FullTurn * std::round((length - angle) / FullTurn)) * axis;
}

/// The covariances of the edges before and after, summed around each point (Kabsch 1976).
std::vector<Eigen::Matrix3d> CorrelateEdges(const std::vector<MorphElement>& elements,
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& target)
{
  std::vector<Eigen::Matrix3d> sums(
    static_cast<std::size_t>(points.rows()), Eigen::Matrix3d::Zero());
  for (const MorphElement& element : elements)
  {
    ForEachEdge(element,
      [&](int a, int b)
      {
        const Eigen::Matrix3d product = element.Weight * EdgeOf(element, a, b, target) *
          EdgeOf(element, a, b, points).transpose();
        sums[element.Corners[a]] += product;
        sums[element.Corners[b]] += product;
      });
  }
  return sums;
}

/// Returns a rotation vector for each point. Each component begins at the point that rotates least,
/// and vectors are passed on along the edges whose ends rotate most alike.
std::vector<Eigen::Vector3d> FindPointTurns(const std::vector<MorphElement>& elements,
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& target, Graph graph,
  DisjointSets& components, const Progress& progress)
{
  const int count = static_cast<int>(points.rows());
  const std::vector<Eigen::Matrix3d> sums = CorrelateEdges(elements, points, target);
  std::vector<Eigen::Quaterniond> rotations(sums.size());
  ParallelFor(
    count, 1024,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        rotations[i] = FitRotation(sums[i], Eigen::Matrix3d::Identity());
      }
    },
    progress.Part(0.0, 0.4));
  std::vector<int> start(sums.size(), -1);
  for (int i = 0; i < count; ++i)
  {
    int& best = start[components.Find(i)];
    best = best < 0 || std::abs(rotations[i].w()) > std::abs(rotations[best].w()) ? i : best;
    for (int k = graph.First[i]; k < graph.First[i + 1]; ++k)
    {
      graph.Lengths[k] = rotations[i].angularDistance(rotations[graph.Neighbours[k]]);
    }
  }
  start.erase(std::remove(start.begin(), start.end(), -1), start.end());
  progress(0.5);
  std::vector<int> before(sums.size(), -1);
  std::vector<Eigen::Vector3d> turns(sums.size(), Eigen::Vector3d::Zero());
  Eigen::VectorXd distances =
    Eigen::VectorXd::Constant(count, std::numeric_limits<double>::infinity());
  int settled = 0;
  // A path whose largest difference is smallest: paths of a minimum spanning tree.
  RunDijkstra(
    graph, { start, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(start.size())) }, distances,
    [&](double distance, int k) { return std::max(distance, graph.Lengths[k]); },
    [&](int node, int from) { before[node] = from; },
    [&](int node)
    {
      const Eigen::Vector3d near = before[node] < 0 ? Eigen::Vector3d::Zero() : turns[before[node]];
      turns[node] = FindTurn(FitRotation(sums[node], ToRotation(near)), near);
      if (++settled % 4096 == 0)
      {
        progress(0.5 + 0.5 * settled / count);
      }
      return false;
    });
  return turns;
}

} // namespace

Eigen::MatrixXd JoinPositions(
  const Eigen::MatrixXd& points, const std::vector<Eigen::MatrixXd>& targets)
{
  Eigen::MatrixXd joined(points.rows(), 3 + 3 * static_cast<Eigen::Index>(targets.size()));
  joined.leftCols<3>() = points;
  Eigen::Index column = 3;
  for (const Eigen::MatrixXd& target : targets)
  {
    joined.middleCols<3>(column) = target;
    column += 3;
  }
  return joined;
}

struct RigidMorph::Prepared
{
  Eigen::MatrixXd Points; ///< n x 3
  std::vector<Eigen::MatrixXd> Targets;
  /// For each point, the first one that coincides with it everywhere: only these have elements.
  std::vector<int> Firsts;
  std::vector<MorphElement> Elements;
  std::vector<std::vector<Eigen::Vector3d>> Turns; ///< for each target and element
  std::vector<int> Components;                     ///< for each point, a point of its component
  SparseCholesky Factor;
};

RigidMorph::RigidMorph(
  const ShapeElements& shape, const std::vector<Eigen::MatrixXd>& targets, const Progress& progress)
  : Impl(std::make_unique<Prepared>())
{
  Prepared& own = *this->Impl;
  RequireFinite(shape.Points, "the shape");
  for (const Eigen::MatrixXd& target : targets)
  {
    if (target.rows() != shape.Points.rows())
    {
      throw InvalidInput("a target has " + std::to_string(target.rows()) +
        " points, and the shape has " + std::to_string(shape.Points.rows()) +
        "; give targets with the points of the shape");
    }
    RequireFinite(target, "a target");
  }
  if (targets.empty())
  {
    throw InvalidInput("there is no target to which the shape moves; give at least one");
  }
  own.Points = shape.Points;
  own.Targets = targets;
  const Eigen::MatrixXd joined = JoinPositions(own.Points, targets);
  own.Firsts = RowFinder(joined).Find(joined);
  for (const Eigen::MatrixXi* corners : { &shape.Lines, &shape.Triangles, &shape.Tetrahedra })
  {
    AppendElements(*corners, own.Points, own.Firsts, own.Elements);
  }
  progress(0.05);

  const int count = static_cast<int>(own.Points.rows());
  DisjointSets components(count);
  std::vector<std::pair<int, int>> links;
  std::vector<Eigen::Triplet<double>> triplets;
  std::vector<char> isUsed(own.Firsts.size(), 0);
  for (const MorphElement& element : own.Elements)
  {
    ForEachEdge(element,
      [&](int a, int b)
      {
        const int from = element.Corners[a], to = element.Corners[b];
        isUsed[from] = isUsed[to] = 1;
        if (from != to)
        {
          components.Merge(from, to);
          links.emplace_back(from, to);
          triplets.insert(triplets.end(),
            { { from, from, element.Weight }, { to, to, element.Weight },
              { from, to, -element.Weight }, { to, from, -element.Weight } });
        }
      });
  }
  // The edges leave one point of each component free, which is fixed at the origin. At shifts the
  // component afterwards.
  for (int i = 0; i < count; ++i)
  {
    own.Components.push_back(components.Find(i));
    if (own.Components.back() == i)
    {
      triplets.emplace_back(i, i, isUsed[i] ? own.Elements.front().Weight : 1.0);
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  own.Factor.Factorize(matrix, progress.Part(0.05, 0.4, "factorising the edges"));

  const Graph graph = BuildGraph(own.Points, std::move(links));
  const auto elementCount = static_cast<int>(own.Elements.size());
  for (std::size_t i = 0; i < targets.size(); ++i)
  {
    const auto share = [&](double part)
    { return 0.4 + 0.6 * (static_cast<double>(i) + part) / static_cast<double>(targets.size()); };
    const std::vector<Eigen::Vector3d> atPoints = FindPointTurns(own.Elements, own.Points,
      targets[i], graph, components, progress.Part(share(0.0), share(0.7), "finding rotations"));
    std::vector<Eigen::Vector3d>& turns = own.Turns.emplace_back(own.Elements.size());
    ParallelFor(
      elementCount, 1024,
      [&](int begin, int end)
      {
        for (int k = begin; k < end; ++k)
        {
          const MorphElement& element = own.Elements[k];
          Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
          ForEachEdge(element,
            [&](int a, int b) {
              sum +=
                EdgeOf(element, a, b, targets[i]) * EdgeOf(element, a, b, own.Points).transpose();
            });
          Eigen::Vector3d near = Eigen::Vector3d::Zero();
          for (int c = 0; c < element.Count; ++c)
          {
            near += atPoints[element.Corners[c]] / element.Count;
          }
          turns[k] = FindTurn(FitRotation(sum, ToRotation(near)), near);
        }
      },
      progress.Part(share(0.7), share(1.0), "finding rotations"));
  }
  progress(1.0);
}

RigidMorph::~RigidMorph() = default;
RigidMorph::RigidMorph(RigidMorph&&) noexcept = default;
RigidMorph& RigidMorph::operator=(RigidMorph&&) noexcept = default;

Eigen::MatrixXd RigidMorph::At(const std::vector<double>& weights, const Progress& progress) const
{
  const Prepared& own = *this->Impl;
  if (weights.size() != own.Targets.size() ||
    !std::all_of(weights.begin(), weights.end(), [](double w) { return std::isfinite(w); }))
  {
    throw InvalidInput("there are " + std::to_string(weights.size()) + " weights for " +
      std::to_string(own.Targets.size()) + " targets; give one finite number for each target");
  }
  // 1. The place of each edge: rotated back from the targets, blended, and rotated by the blended
  // rotation. So each target is reached, whatever the rotations.
  std::vector<Eigen::Matrix<double, 3, 4>> pulls(own.Elements.size());
  ParallelFor(
    static_cast<int>(own.Elements.size()), 1024,
    [&](int begin, int end)
    {
      for (int k = begin; k < end; ++k)
      {
        const MorphElement& element = own.Elements[k];
        Eigen::Vector3d turn = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < weights.size(); ++i)
        {
          turn += weights[i] * own.Turns[i][k];
        }
        std::array<Eigen::Vector3d, 6> edges;
        int edge = 0;
        ForEachEdge(
          element, [&](int a, int b) { edges[edge++] = EdgeOf(element, a, b, own.Points); });
        std::array<Eigen::Vector3d, 6> blended = edges;
        for (std::size_t i = 0; i < weights.size(); ++i)
        {
          const Eigen::Matrix3d back = ToRotation(-own.Turns[i][k]);
          edge = 0;
          ForEachEdge(element,
            [&](int a, int b)
            {
              blended[edge] +=
                weights[i] * (back * EdgeOf(element, a, b, own.Targets[i]) - edges[edge]);
              ++edge;
            });
        }
        const Eigen::Matrix3d rotation = ToRotation(turn);
        pulls[k].setZero();
        edge = 0;
        ForEachEdge(element,
          [&](int a, int b)
          {
            const Eigen::Vector3d pull = element.Weight * (rotation * blended[edge++]);
            pulls[k].col(a) -= pull;
            pulls[k].col(b) += pull;
          });
      }
    },
    progress.Part(0.0, 0.5));
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(own.Points.rows(), 3);
  for (std::size_t k = 0; k < pulls.size(); ++k)
  {
    for (int c = 0; c < own.Elements[k].Count; ++c)
    {
      sums.row(own.Elements[k].Corners[c]) += pulls[k].col(c).transpose();
    }
  }
  // 2. The positions, up to a translation of each component.
  Eigen::MatrixXd moved = own.Factor.Solve(sums, progress.Part(0.5, 0.9));
  // 3. The translation, from the means.
  Eigen::MatrixXd straight = own.Points;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    straight += weights[i] * (own.Targets[i] - own.Points);
  }
  Eigen::MatrixXd shifts = Eigen::MatrixXd::Zero(moved.rows(), 3);
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(moved.rows());
  for (int i = 0; i < moved.rows(); ++i)
  {
    if (own.Firsts[i] == i)
    {
      shifts.row(own.Components[i]) += straight.row(i) - moved.row(i);
      counts(own.Components[i]) += 1.0;
    }
  }
  Eigen::MatrixXd result(moved.rows(), 3);
  for (int i = 0; i < moved.rows(); ++i)
  {
    const int first = own.Firsts[i], component = own.Components[first];
    result.row(i) = moved.row(first) + shifts.row(component) / counts(component);
  }
  progress(1.0);
  return result;
}

} // namespace shape
