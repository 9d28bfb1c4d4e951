#include "Skeleton/Private/SkeletonBranches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;
using Path = std::vector<int>;

/// Branches with an end are longer than this number of edges.
constexpr double ShortestSpur = 3.0;
/// Number of rounds in which the points of a branch move to the middle of their neighbours.
constexpr int SmoothingRounds = 4;

Eigen::MatrixXd PositionsOf(const CurveGraph& graph)
{
  Eigen::MatrixXd positions(graph.Size(), 3);
  for (int i = 0; i < graph.Size(); ++i)
  {
    positions.row(i) = graph.Positions[i].transpose();
  }
  return positions;
}

double LengthOf(const Eigen::MatrixXd& polyline)
{
  const Eigen::Index edges = polyline.rows() - 1;
  return (polyline.bottomRows(edges) - polyline.topRows(edges)).rowwise().norm().sum();
}

/// Smooths the points of a branch; its ends stay, except those of a cycle without a junction.
Eigen::MatrixXd SmoothPath(const CurveGraph& graph, const Path& path, bool cycle)
{
  const int count = static_cast<int>(path.size());
  Eigen::MatrixXd points(count, 3);
  for (int i = 0; i < count; ++i)
  {
    points.row(i) = graph.Positions[path[i]].transpose();
  }
  for (int round = 0; round < SmoothingRounds && count > 2; ++round)
  {
    const Eigen::MatrixXd before = points;
    for (int i = 1; i + 1 < count; ++i)
    {
      points.row(i) = 0.25 * (before.row(i - 1) + 2.0 * before.row(i) + before.row(i + 1));
    }
    if (cycle)
    {
      points.row(0) = 0.25 * (before.row(count - 2) + 2.0 * before.row(0) + before.row(1));
      points.row(count - 1) = points.row(0);
    }
  }
  return points;
}

/// Whether the end of a branch lies within the ball around a node that is not on the branch, or
/// around its junction.
bool IsCovered(const CurveGraph& graph, const Eigen::VectorXd& radii, const Path& path)
{
  std::vector<bool> own(graph.Size(), false);
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    own[path[i]] = true;
  }
  const Eigen::Vector3d& tip = graph.Positions[path.back()];
  for (int i = 0; i < graph.Size(); ++i)
  {
    if (!own[i] && (graph.Positions[i] - tip).norm() < radii(i))
    {
      return true;
    }
  }
  return false;
}

/// Removes the shortest branch whose end is covered or which is shorter than `shortest`. Returns
/// false if there is none.
bool RemoveShortestSpur(CurveGraph& graph, const SignedDistance& surface, double shortest)
{
  const std::vector<std::vector<int>> links = ListLinksOfNodes(graph);
  const Eigen::VectorXd radii = -surface.Evaluate(PositionsOf(graph)).Distances;
  Path spur;
  double least = 0.0;
  for (Path path : TracePaths(graph))
  {
    if (links[path.front()].size() == 1)
    {
      std::reverse(path.begin(), path.end());
    }
    if (links[path.back()].size() != 1 || links[path.front()].size() < 3)
    {
      continue;
    }
    const double length = LengthOf(SmoothPath(graph, path, false));
    if ((spur.empty() || length < least) && (length < shortest || IsCovered(graph, radii, path)))
    {
      spur = path;
      least = length;
    }
  }
  std::vector<bool> removed(graph.Size(), false);
  for (std::size_t i = 1; i < spur.size(); ++i)
  {
    removed[spur[i]] = true;
  }
  graph = RemoveNodes(graph, removed);
  return !spur.empty();
}

/// Returns positions at equal distances along a polyline, with both ends.
Eigen::MatrixXd Resample(const Eigen::MatrixXd& points, int edges)
{
  const Eigen::Index count = points.rows();
  Eigen::VectorXd along = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 1; i < count; ++i)
  {
    along(i) = along(i - 1) + (points.row(i) - points.row(i - 1)).norm();
  }
  Eigen::MatrixXd result(edges + 1, 3);
  Eigen::Index piece = 1;
  for (int k = 0; k <= edges; ++k)
  {
    const double at = along(count - 1) * k / edges;
    while (piece + 1 < count && along(piece) < at)
    {
      ++piece;
    }
    const double length = along(piece) - along(piece - 1);
    const double share = length > 0.0 ? std::min((at - along(piece - 1)) / length, 1.0) : 0.0;
    result.row(k) = (1.0 - share) * points.row(piece - 1) + share * points.row(piece);
  }
  return result;
}

/// Collects the points of branches.
struct Collector
{
  std::vector<RowVector3d> Points;
  std::map<int, int> Known; ///< from nodes of the graph to points
  std::vector<Path> Branches;

  int Add(const RowVector3d& position)
  {
    this->Points.push_back(position);
    return static_cast<int>(this->Points.size()) - 1;
  }

  int AddNode(int node, const RowVector3d& position)
  {
    const auto [found, isNew] = this->Known.emplace(node, 0);
    if (isNew)
    {
      found->second = this->Add(position);
    }
    return found->second;
  }

  void AddBranch(const Path& path, const Eigen::MatrixXd& points)
  {
    Path branch = { this->AddNode(path.front(), points.row(0)) };
    for (Eigen::Index i = 1; i + 1 < points.rows(); ++i)
    {
      branch.push_back(this->Add(points.row(i)));
    }
    if (path.size() > 1)
    {
      branch.push_back(this->AddNode(path.back(), points.row(points.rows() - 1)));
    }
    this->Branches.push_back(branch);
  }
};

} // namespace

CurveSkeleton MakeBranches(const CurveGraph& curves, const SignedDistance& surface, double length)
{
  CurveGraph graph = MergeShortLinks(curves, 0.5 * length);
  while (RemoveShortestSpur(graph, surface, ShortestSpur * length))
  {
  }
  const std::vector<std::vector<int>> links = ListLinksOfNodes(graph);
  Collector collector;
  std::map<std::pair<int, int>, int> between; // how many branches two nodes have
  const std::vector<Path> paths = TracePaths(graph);
  for (const Path& path : paths)
  {
    ++between[std::minmax(path.front(), path.back())];
  }
  for (const Path& path : paths)
  {
    const bool closed = path.front() == path.back();
    if (path.size() == 1)
    {
      collector.AddBranch(path, graph.Positions[path[0]].transpose());
      continue;
    }
    const int least = closed ? 3 : between[std::minmax(path.front(), path.back())] > 1 ? 2 : 1;
    const Eigen::MatrixXd smooth =
      SmoothPath(graph, path, closed && links[path.front()].size() == 2);
    const int edges = std::max(least, static_cast<int>(std::lround(LengthOf(smooth) / length)));
    collector.AddBranch(path, Resample(smooth, edges));
  }
  CurveSkeleton skeleton;
  skeleton.Branches = collector.Branches;
  skeleton.Points.resize(static_cast<Eigen::Index>(collector.Points.size()), 3);
  for (std::size_t i = 0; i < collector.Points.size(); ++i)
  {
    skeleton.Points.row(static_cast<Eigen::Index>(i)) = collector.Points[i];
  }
  skeleton.Degrees = Eigen::VectorXi::Zero(skeleton.Points.rows());
  for (const Path& branch : skeleton.Branches)
  {
    for (std::size_t i = 1; i < branch.size(); ++i)
    {
      ++skeleton.Degrees(branch[i - 1]);
      ++skeleton.Degrees(branch[i]);
    }
  }
  const Eigen::VectorXd distances = surface.Evaluate(skeleton.Points).Distances;
  skeleton.Radii = distances.cwiseAbs();
  skeleton.OutsidePoints = static_cast<int>((distances.array() > 0.0).count());
  skeleton.Components = CountComponents(graph);
  skeleton.Cycles = CountCycles(graph);
  return skeleton;
}

} // namespace shape
