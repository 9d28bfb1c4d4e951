#include "Geometry/SampledSurface.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/Private/PointNormals.h"
#include "Geometry/SurfaceWelding.h"
#include "Geometry/TangentFrame.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

double Cross(const RowVector2d& a, const RowVector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// A fixed pseudo-random direction for each index, in [-1, 1]^3 (the finaliser of splitmix64).
RowVector3d Jitter(int index)
{
  RowVector3d direction;
  for (int k = 0; k < 3; ++k)
  {
    std::uint64_t bits = (3ULL * static_cast<std::uint64_t>(index) + k + 1) * 0x9e3779b97f4a7c15ULL;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
    bits ^= bits >> 31;
    direction(k) = static_cast<double>(bits >> 11) * 0x1.0p-52 - 1.0;
  }
  return direction;
}

/// The convex hull of positions, counter-clockwise (Andrew's monotone chain).
std::vector<int> FindHull(const std::vector<RowVector2d>& positions)
{
  std::vector<int> order(positions.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    {
      const RowVector2d &p = positions[a], &q = positions[b];
      return p.x() != q.x() ? p.x() < q.x() : p.y() != q.y() ? p.y() < q.y() : a < b;
    });
  std::vector<int> hull;
  const auto chain = [&](auto begin, auto end)
  {
    const std::size_t base = hull.size();
    for (auto i = begin; i != end; ++i)
    {
      while (hull.size() >= base + 2)
      {
        const RowVector2d &a = positions[hull[hull.size() - 2]], &b = positions[hull.back()];
        if (Cross(b - a, positions[*i] - b) > 0.0)
        {
          break;
        }
        hull.pop_back();
      }
      hull.push_back(*i);
    }
    hull.pop_back(); // it begins the other chain
  };
  chain(order.begin(), order.end());
  chain(order.rbegin(), order.rend());
  return hull;
}

/// The Delaunay triangles around the origin: pairs of neighbours, counter-clockwise.
struct Star
{
  std::vector<std::array<int, 2>> Edges; ///< indices of positions
  bool IsClosed = false;
  double LargestDiameter = 0.0; ///< of the circles through the origin and an edge
};

/// positions: those of the neighbours. reach: the largest radius of a circumscribed circle.
Star FindStar(const std::vector<RowVector2d>& positions, double reach)
{
  Star star;
  std::vector<RowVector2d> inverted;
  for (const RowVector2d& position : positions)
  {
    inverted.emplace_back(position / position.squaredNorm());
  }
  const std::vector<int> hull = positions.size() < 2 ? std::vector<int>() : FindHull(inverted);
  star.IsClosed = hull.size() >= 3;
  for (std::size_t i = 0; i < hull.size(); ++i)
  {
    const std::array<int, 2> edge{ hull[i], hull[(i + 1) % hull.size()] };
    const RowVector2d &a = positions[edge[0]], &b = positions[edge[1]];
    // The circle through 0, a and b has this radius.
    const double twice = Cross(a, b), lengths = a.norm() * b.norm() * (a - b).norm();
    const bool isNear = lengths <= 2.0 * twice * reach;
    // The circle contains no point if the line of the inverted points has the origin on their side.
    if (twice > 0.0 && isNear)
    {
      star.Edges.push_back(edge);
      star.LargestDiameter = std::max(star.LargestDiameter, lengths / twice);
    }
    else
    {
      star.IsClosed = false;
    }
  }
  return star;
}

/// The distinct points, and the neighbours of each.
class Samples
{
public:
  Samples(const Eigen::MatrixXd& points, const std::vector<int>& nodes,
    const Eigen::MatrixXd& normals, int nearest)
    : Positions(points(nodes, Eigen::all))
    , Normals(normals)
    , Nearest(nearest)
    , Tree(this->Positions)
    , Near(this->Positions.rows())
  {
  }

  /// The circles of the star are empty if the neighbourhood contains them. Otherwise the star is
  /// found again among all points that could lie in a circle of the largest radius.
  Star StarOf(int node, std::vector<int>& neighbours) const
  {
    const std::vector<int>& near = this->Near[node].first;
    const RowVector3d position = this->Positions.row(node);
    const double reach = near.empty() ? 0.0 : (this->Positions.row(near.back()) - position).norm();
    const Star star = this->StarAmong(near, node, reach, neighbours);
    return star.IsClosed && star.LargestDiameter <= reach
      ? star
      : this->StarAmong(this->Tree.Within(position, 2.0 * reach), node, reach, neighbours);
  }

  void FindNeighbours(const Progress& progress)
  {
    ParallelFor(
      static_cast<int>(this->Near.size()), 256,
      [this](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          const RowVector3d position = this->Positions.row(i);
          auto& [near, least] = this->Near[i];
          near = this->Tree.Nearest(position, this->Nearest + 1);
          near.erase(std::remove(near.begin(), near.end(), i), near.end());
          least = near.empty() ? 0.0 : (this->Positions.row(near.front()) - position).norm();
        }
      },
      progress);
  }

  int Size() const { return static_cast<int>(this->Near.size()); }

private:
  /// reach: the largest radius of a circle.
  Star StarAmong(
    const std::vector<int>& others, int node, double reach, std::vector<int>& neighbours) const
  {
    // relative to the distance to the nearest point: far above rounding, far below the spacing
    constexpr double moved = 1e-6;
    const RowVector3d normal = this->Normals.row(node);
    const TangentFrame frame = BuildTangentFrame(this->Positions.row(node), normal);
    const auto shifted = [&](int at) -> RowVector3d
    { return this->Positions.row(at) + moved * this->Near[at].second * Jitter(at); };
    std::vector<RowVector2d> positions;
    neighbours.clear();
    for (const int other : others)
    {
      if (other == node)
      {
        continue;
      }
      const RowVector3d offset = shifted(other) - shifted(node);
      const RowVector2d flat(offset.dot(frame.XAxis), offset.dot(frame.YAxis));
      if (this->Normals.row(other).dot(normal) > 0.0 && flat.squaredNorm() > 0.0)
      {
        positions.emplace_back(flat * (offset.norm() / flat.norm()));
        neighbours.push_back(other);
      }
    }
    return FindStar(positions, reach);
  }

  Eigen::MatrixXd Positions;
  const Eigen::MatrixXd& Normals;
  int Nearest;
  PointTree Tree;
  std::vector<std::pair<std::vector<int>, double>> Near; ///< and the distance to the nearest
};

Eigen::MatrixXd RequireNormals(const Eigen::MatrixXd& normals, const std::vector<int>& nodes)
{
  Eigen::MatrixXd unit(static_cast<Eigen::Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const RowVector3d normal = normals.row(nodes[i]);
    if (!normal.allFinite() || normal.isZero(0.0))
    {
      throw InvalidInput("the normal at point " + std::to_string(nodes[i]) +
        " is zero or not finite; remove the array Normals, so that normals are estimated");
    }
    unit.row(static_cast<Eigen::Index>(i)) = normal.stableNormalized();
  }
  return unit;
}

/// Counts how often each triangle occurs, and keeps the first of equal ones, sorted by corners.
void KeepEach(std::vector<std::array<int, 3>>& triangles, SampledSurface& result)
{
  const auto sorted = [](std::array<int, 3> corners)
  {
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::stable_sort(triangles.begin(), triangles.end(),
    [&](const auto& a, const auto& b) { return sorted(a) < sorted(b); });
  std::vector<int> first;
  std::vector<double> shares;
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i)
  {
    if (first.empty() || sorted(triangles[i]) != sorted(triangles[first.back()]))
    {
      first.push_back(i);
      shares.push_back(0.0);
    }
    shares.back() += 1.0 / 3.0;
  }
  result.Surface.Triangles.resize(static_cast<Eigen::Index>(first.size()), 3);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    const std::array<int, 3>& corners = triangles[first[i]];
    result.Surface.Triangles.row(static_cast<Eigen::Index>(i)) << corners[0], corners[1],
      corners[2];
  }
  result.Shares =
    Eigen::Map<const Eigen::VectorXd>(shares.data(), static_cast<Eigen::Index>(shares.size()));
}

} // namespace

SampledSurface ConnectSamples(const Eigen::MatrixXd& points, const Eigen::MatrixXd& normals,
  const SampledSurfaceOptions& options, const Progress& progress)
{
  RequireOption(options.Nearest >= 6, "Nearest", options.Nearest, "at least 6");
  RequireFinite(points, "the points");
  RequireExtent(points, "the points");
  const std::vector<int> first = FindPointsWithinTolerance(points, progress.Part(0.0, 0.1));
  std::vector<int> nodes;
  for (int i = 0; i < static_cast<int>(first.size()); ++i)
  {
    if (first[i] == i)
    {
      nodes.push_back(i);
    }
  }
  const Eigen::MatrixXd atNodes = normals.rows() > 0
    ? RequireNormals(normals, nodes)
    : EstimatePointNormals(
        points(nodes, Eigen::all), {}, progress.Part(0.1, 0.5, "estimating the normals"));
  Samples samples(points, nodes, atNodes, options.Nearest);
  samples.FindNeighbours(progress.Part(0.5, 0.7, "connecting the points"));

  SampledSurface result;
  std::vector<std::array<int, 3>> triangles;
  result.OnRim.assign(points.rows(), 0);
  std::vector<int> neighbours;
  for (int i = 0; i < samples.Size(); ++i)
  {
    const Star star = samples.StarOf(i, neighbours);
    for (const auto& [a, b] : star.Edges)
    {
      triangles.push_back({ nodes[i], nodes[neighbours[a]], nodes[neighbours[b]] });
    }
    result.OnRim[nodes[i]] = star.IsClosed ? 0 : 1;
    if (i % 4096 == 0)
    {
      progress(0.7 + 0.2 * i / samples.Size());
    }
  }
  if (triangles.empty())
  {
    throw InvalidInput("the " + std::to_string(nodes.size()) +
      " distinct points span no surface; give at least 3 points that are not on a line");
  }
  result.Surface.Points = points;
  KeepEach(triangles, result);
  std::vector<Eigen::Index> row(points.rows());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    row[nodes[i]] = static_cast<Eigen::Index>(i);
  }
  result.Normals.resize(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    result.Normals.row(i) = atNodes.row(row[first[i]]);
    result.OnRim[i] = result.OnRim[first[i]];
  }
  progress(1.0);
  return result;
}

double ComputeSpacing(const SampledSurface& samples)
{
  const Mesh& surface = samples.Surface;
  double sum = 0.0;
  for (const auto& corners : surface.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      sum += (surface.Points.row(corners(k)) - surface.Points.row(corners((k + 1) % 3))).norm();
    }
  }
  return sum / (3.0 * static_cast<double>(surface.Triangles.rows()));
}

} // namespace shape
