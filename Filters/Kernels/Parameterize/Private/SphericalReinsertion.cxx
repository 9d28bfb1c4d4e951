#include "Parameterize/Private/SphericalReinsertion.h"

#include "Base/Errors.h"
#include "Parameterize/Private/VertexRings.h"
#include "Parameterize/SphericalRelaxation.h"
#include "Parameterize/SphericalTriangles.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

using Rings = std::vector<std::vector<int>>;

/// The stack of merges, and the index of the first merge of each level of the hierarchy.
struct Merges
{
  std::vector<int> Order;
  Rings Kept;
  std::vector<std::size_t> Levels;

  void Add(VertexRings& rings, int point, int into)
  {
    this->Kept.push_back(rings.Merge(point, into));
    this->Order.push_back(point);
  }
};

/// Returns the triangles around `point` with their targets: equilateral, and areas in proportion to
/// the number of points merged into their corners (`loads`), relative to the star.
std::vector<StarTriangle> WantedStar(const VertexRings& rings, const std::vector<double>& loads,
  const Eigen::MatrixXd& points, int point, double areaWeight)
{
  // The cotangent of 60 degrees.
  const double cotangent = 1.0 / std::sqrt(3.0);
  const std::vector<int>& ring = rings.Around(point);
  // A point's load is shared by the triangles around it.
  const auto loadOf = [&](int i) { return loads[i] / rings.Around(i).size(); };
  std::vector<StarTriangle> star;
  double area = 0.0, load = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    const int b = ring[k], c = ring[(k + 1) % ring.size()];
    const double own = loadOf(point) + loadOf(b) + loadOf(c);
    star.push_back({ b, c, cotangent, cotangent, cotangent, own });
    area += ComputeSphericalDeterminant(points.row(point), points.row(b), points.row(c));
    load += own;
  }
  for (StarTriangle& t : star)
  {
    t.AreaTerm = areaWeight * area * (t.AreaTerm / load) * (t.AreaTerm / load);
  }
  return star;
}

/// Returns the minimum quality det / (sum of squared edges) of the triangles created by merging a
/// point into ring[0]; negative if one does not face outwards.
double MergedQuality(const Eigen::MatrixXd& points, const std::vector<int>& ring)
{
  double minimum = 1.0;
  const Eigen::RowVector3d a = points.row(ring[0]);
  for (std::size_t k = 1; k + 1 < ring.size(); ++k)
  {
    const Eigen::RowVector3d b = points.row(ring[k]);
    const Eigen::RowVector3d c = points.row(ring[k + 1]);
    if (!IsFacingOutwards(a, b, c))
    {
      return -1.0;
    }
    minimum = std::min(minimum,
      ComputeSphericalDeterminant(a, b, c) /
        ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm()));
  }
  return minimum;
}

/// Merges `point` into the neighbour that gives the best triangles, if one sees the whole ring.
bool MergeWhereSeen(VertexRings& rings, const Eigen::MatrixXd& points, int point, Merges& merges)
{
  int best = -1;
  double bestQuality = 0.0;
  for (const int into : rings.Around(point))
  {
    const double quality = MergedQuality(points, rings.RingFrom(point, into));
    if (quality > bestQuality && rings.CanMerge(point, into))
    {
      best = into;
      bestQuality = quality;
    }
  }
  if (best >= 0)
  {
    merges.Add(rings, point, best);
  }
  return best >= 0;
}

/// Merges points at and around the flipped triangles until none is left. Returns false if that
/// fails or takes more than `maximum` merges.
bool MergeFlipped(VertexRings& rings, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, int maximum, Merges& merges, const Progress& progress)
{
  // A point that does not see its whole ring is merged into a neighbour that does. If no point can
  // be merged, the points around them are merged as well.
  std::vector<int> suspects;
  for (const int t : FindFlippedTriangles(triangles, points))
  {
    suspects.insert(suspects.end(), { triangles(t, 0), triangles(t, 1), triangles(t, 2) });
  }
  for (int ringsAround = 0; ringsAround < 12 && static_cast<int>(merges.Order.size()) <= maximum;)
  {
    progress(0.0);
    std::sort(suspects.begin(), suspects.end());
    suspects.erase(std::unique(suspects.begin(), suspects.end()), suspects.end());
    std::vector<int> left;
    bool merged = false;
    for (const int point : suspects)
    {
      if (rings.Contains(point) && !IsInStarKernel(points, points.row(point), rings.Around(point)))
      {
        left.push_back(point);
      }
    }
    if (left.empty())
    {
      return true;
    }
    // Flipped stars are processed first, then the points added around them.
    for (const int point : left)
    {
      merged = (rings.Contains(point) && MergeWhereSeen(rings, points, point, merges)) || merged;
    }
    for (std::size_t i = 0; !merged && ringsAround > 0 && i < suspects.size(); ++i)
    {
      merged = rings.Contains(suspects[i]) && MergeWhereSeen(rings, points, suspects[i], merges);
    }
    if (!merged)
    {
      ++ringsAround;
      const std::vector<int> inner = suspects;
      for (const int point : inner)
      {
        const std::vector<int>& around = rings.Around(point);
        suspects.insert(suspects.end(), around.begin(), around.end());
      }
    }
  }
  return false;
}

/// Merges all points down to four. Each level merges points that share no ring and have few
/// neighbours, which keeps the levels few and the rings short.
void MergeAll(VertexRings& rings, Merges& merges, const Progress& progress)
{
  // The mean number of neighbours is 6, so most points qualify. It doubles when no point does.
  std::size_t maximum = 7;
  while (rings.Remaining() > 4)
  {
    const int before = rings.Remaining();
    progress(1.0 - static_cast<double>(before) / rings.Size());
    merges.Levels.push_back(merges.Order.size());
    std::vector<char> touched(rings.Size(), 0);
    for (int point = 0; point < rings.Size() && rings.Remaining() > 4; ++point)
    {
      if (!rings.Contains(point) || touched[point] || rings.Around(point).size() > maximum)
      {
        continue;
      }
      int best = -1;
      for (const int into : rings.Around(point))
      {
        if ((best < 0 || rings.Around(into).size() < rings.Around(best).size()) &&
          rings.CanMerge(point, into))
        {
          best = into;
        }
      }
      if (best >= 0)
      {
        merges.Add(rings, point, best);
        // Merges of one level share no ring.
        for (const int near : merges.Kept.back())
        {
          touched[near] = 1;
        }
      }
    }
    maximum = rings.Remaining() == before ? 2 * maximum : maximum;
  }
}

void PlaceTetrahedron(const VertexRings& rings, Eigen::MatrixXd& points)
{
  int first = 0;
  while (!rings.Contains(first))
  {
    ++first;
  }
  // The ring of the first point is counter-clockwise, so the tetrahedron faces outwards.
  const std::vector<int>& others = rings.Around(first);
  points.row(first) << 1.0, 1.0, 1.0;
  points.row(others[0]) << -1.0, 1.0, -1.0;
  points.row(others[1]) << -1.0, -1.0, 1.0;
  points.row(others[2]) << 1.0, -1.0, -1.0;
  for (const int i : { first, others[0], others[1], others[2] })
  {
    points.row(i).normalize();
  }
}

/// Undoes the merges. Reinserted points are relaxed and may move; if there are levels, all points
/// may. Returns the point that has no room, or -1.
int Reinsert(VertexRings& rings, const Merges& merges, double areaWeight, Eigen::MatrixXd& points,
  const Progress& progress)
{
  // A point's load is 1 plus the loads of the points that are merged into it.
  std::vector<double> loads(rings.Size(), 1.0);
  for (std::size_t i = 0; i < merges.Order.size(); ++i)
  {
    loads[merges.Kept[i][0]] += loads[merges.Order[i]];
  }
  std::vector<char> movable(rings.Size(), merges.Levels.empty() ? 0 : 1);
  const auto relax = [&](int point)
  {
    if (movable[point])
    {
      RelaxPoint(points, point, WantedStar(rings, loads, points, point, areaWeight));
    }
  };
  std::size_t level = merges.Levels.size();
  for (std::size_t i = merges.Order.size(); i-- > 0;)
  {
    const int point = merges.Order[i];
    rings.Restore(point, merges.Kept[i]);
    loads[merges.Kept[i][0]] -= loads[point];
    if (!MovePointIntoKernel(points, point, merges.Kept[i]))
    {
      return point;
    }
    movable[point] = 1;
    // Relaxation makes room for the next points.
    for (int round = 0; round < 3; ++round)
    {
      relax(point);
      for (const int near : rings.Around(point))
      {
        relax(near);
      }
    }
    // At the end of a level all points are relaxed, which spreads its areas over the sphere.
    const bool levelEnds = level > 0 && merges.Levels[level - 1] == i;
    level -= levelEnds ? 1 : 0;
    for (int sweep = 0; sweep < (levelEnds ? 5 : 0); ++sweep)
    {
      for (int j = 0; j < rings.Size(); ++j)
      {
        if (rings.Contains(j))
        {
          relax(j);
        }
      }
      progress(1.0 - static_cast<double>(i) / merges.Order.size());
    }
    if (i % 256 == 0)
    {
      progress(1.0 - static_cast<double>(i) / merges.Order.size());
    }
  }
  return -1;
}

std::vector<int> Sorted(std::vector<int> list)
{
  std::sort(list.begin(), list.end());
  return list;
}

} // namespace

SphericalReinsertionResult ReinsertFlipped(const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, int maximum, const Progress& progress)
{
  SphericalReinsertionResult result;
  result.Points = points;
  // Praun and Hoppe 2003, where it is needed: merge until nothing is flipped, then reinsert in the
  // reverse order.
  VertexRings rings(triangles, static_cast<int>(points.rows()));
  Merges merges;
  if (ComputeCoveringDegree(triangles, points) == 1 &&
    MergeFlipped(rings, triangles, points, maximum, merges, progress.Part(0.0, 0.5)) &&
    Reinsert(rings, merges, 0.0, result.Points, progress.Part(0.5, 1.0)) == -1)
  {
    result.Reached = FindFlippedTriangles(triangles, result.Points).empty();
    result.Reinserted = Sorted(merges.Order);
  }
  if (!result.Reached)
  {
    result.Points = points;
  }
  return result;
}

SphericalReinsertionResult ReinsertAll(
  const Eigen::MatrixXi& triangles, int n, double areaWeight, const Progress& progress)
{
  SphericalReinsertionResult result;
  result.Points = Eigen::MatrixXd::Zero(n, 3);
  // Praun and Hoppe 2003: merge down to a tetrahedron, then reinsert in the reverse order.
  VertexRings rings(triangles, n);
  Merges merges;
  MergeAll(rings, merges, progress.Part(0.0, 0.1));
  PlaceTetrahedron(rings, result.Points);
  const int failed = Reinsert(rings, merges, areaWeight, result.Points, progress.Part(0.1, 1.0));
  if (failed != -1)
  {
    throw SolveFailure("rounding leaves no room on the sphere for point " + std::to_string(failed) +
      "; coarsen the surface or remove its longest and thinnest parts");
  }
  result.Reinserted = Sorted(merges.Order);
  result.Reached = true;
  return result;
}

} // namespace shape
