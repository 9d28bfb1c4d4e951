#include "CutPaste/GapBridges.h"

#include "Base/Errors.h"
#include "Geometry/SegmentProjection.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// A boundary edge, with its triangle to the left.
struct Border
{
  std::array<int, 2> Ends;
  int Component;
  RowVector3d From, To, Outwards; ///< Outwards: in the plane of the triangle

  RowVector3d Direction() const { return this->To - this->From; }
  double DistanceOf(const RowVector3d& position) const
  {
    const double share = ProjectOntoSegment(position, this->From, this->To);
    return (position - this->From - share * this->Direction()).norm();
  }
  bool IsOutside(const RowVector3d& position) const
  {
    return (position - this->From).dot(this->Outwards) > 0.0;
  }
};

std::vector<Border> FindBorders(const Mesh& surface)
{
  const std::vector<HalfEdge> sorted = SortHalfEdges(surface.Triangles, surface.Points.rows());
  const Eigen::VectorXi components = ComputeTopology(surface, sorted).ComponentId;
  const auto isSame = [&](std::size_t a, std::size_t b)
  { return sorted[a].Low() == sorted[b].Low() && sorted[a].High() == sorted[b].High(); };
  std::vector<Border> borders;
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    if ((i > 0 && isSame(i - 1, i)) || (i + 1 < sorted.size() && isSame(i, i + 1)))
    {
      continue;
    }
    const auto& [begin, end, triangle, corner] = sorted[i];
    const RowVector3d from = surface.Points.row(begin), to = surface.Points.row(end);
    const RowVector3d third = surface.Points.row(surface.Triangles(triangle, (corner + 2) % 3));
    const RowVector3d along = to - from;
    // Away from the third corner, perpendicular to the edge.
    const RowVector3d inwards =
      third - from - (third - from).dot(along) / along.squaredNorm() * along;
    if (along.squaredNorm() > 0.0 && inwards.squaredNorm() > 0.0)
    {
      borders.push_back({ { begin, end }, components(begin), from, to, -inwards });
    }
  }
  return borders;
}

bool AreFacing(const Border& one, const Border& other, double width)
{
  const double apart = std::min({ one.DistanceOf(other.From), one.DistanceOf(other.To),
    other.DistanceOf(one.From), other.DistanceOf(one.To) });
  return one.Component != other.Component && one.Direction().dot(other.Direction()) < 0.0 &&
    apart <= width &&
    (one.IsOutside(0.5 * (other.From + other.To)) || other.IsOutside(0.5 * (one.From + one.To)));
}

/// For each border, the ends of those that face it. A sweep along the x axis.
std::vector<std::set<int>> FindFacingPoints(
  const std::vector<Border>& borders, double width, const Progress& progress)
{
  const auto low = [&](int i) { return std::min(borders[i].From.x(), borders[i].To.x()); };
  const auto high = [&](int i) { return std::max(borders[i].From.x(), borders[i].To.x()); };
  std::vector<int> order(borders.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = static_cast<int>(i);
  }
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return std::make_pair(low(a), a) < std::make_pair(low(b), b); });
  std::vector<std::set<int>> facing(borders.size());
  std::vector<int> near; // those that may still face the next ones
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    const int here = order[k];
    near.erase(std::remove_if(near.begin(), near.end(),
                 [&](int other) { return high(other) + width < low(here); }),
      near.end());
    for (const int other : near)
    {
      if (AreFacing(borders[here], borders[other], width))
      {
        facing[here].insert(borders[other].Ends.begin(), borders[other].Ends.end());
        facing[other].insert(borders[here].Ends.begin(), borders[here].Ends.end());
      }
    }
    near.push_back(here);
    progress(static_cast<double>(k) / static_cast<double>(order.size()));
  }
  return facing;
}

/// The positions, moved by less than rounding can be seen, in units of each border's length.
class MovedPoints
{
public:
  explicit MovedPoints(const Eigen::MatrixXd& points)
    : Points(points)
    , Directions(points.rows(), 3)
  {
    std::mt19937 random(1);
    for (double& coordinate : this->Directions.reshaped())
    {
      constexpr double half = 2147483648.0; // of the generator's range
      coordinate = static_cast<double>(random()) / half - 1.0;
    }
  }

  /// The cotangent of the angle under which an edge is seen.
  double Cotangent(const std::array<int, 2>& edge, int apex, double scale) const
  {
    const RowVector3d a = this->At(edge[0], scale) - this->At(apex, scale);
    const RowVector3d b = this->At(edge[1], scale) - this->At(apex, scale);
    return a.dot(b) / a.cross(b).norm();
  }
  double Circumradius(const std::array<int, 3>& corners) const
  {
    const RowVector3d a = this->Points.row(corners[0]), b = this->Points.row(corners[1]),
                      c = this->Points.row(corners[2]);
    return (a - b).norm() * (b - c).norm() * (c - a).norm() / (2.0 * (b - a).cross(c - a).norm());
  }

private:
  RowVector3d At(int point, double scale) const
  {
    constexpr double moved = 1e-6; // far above rounding, far below what can be seen
    return this->Points.row(point) + moved * scale * this->Directions.row(point);
  }

  const Eigen::MatrixXd& Points;
  Eigen::MatrixXd Directions;
};

} // namespace

Eigen::MatrixXi FindGapBridges(const Mesh& surface, double width, const Progress& progress)
{
  const std::vector<Border> borders = FindBorders(surface);
  const std::vector<std::set<int>> facing = FindFacingPoints(borders, width, progress);
  const MovedPoints points(surface.Points);
  std::vector<std::pair<double, std::array<int, 3>>> triangles; // by circumradius
  for (std::size_t i = 0; i < borders.size(); ++i)
  {
    const Border& border = borders[i];
    int best = -1;
    double smallest = 0.0;
    for (const int apex : facing[i])
    {
      const double cotangent = points.Cotangent(border.Ends, apex, width);
      if (border.IsOutside(surface.Points.row(apex)) && (best < 0 || cotangent < smallest))
      {
        best = apex;
        smallest = cotangent;
      }
    }
    if (best >= 0)
    {
      const std::array<int, 3> corners{ border.Ends[1], border.Ends[0], best };
      triangles.emplace_back(points.Circumradius(corners), corners);
    }
  }
  std::sort(triangles.begin(), triangles.end());
  std::set<std::array<int, 2>> taken; // directed edges
  std::vector<std::array<int, 3>> kept;
  for (const auto& [radius, corners] : triangles)
  {
    const std::array<std::array<int, 2>, 3> sides{ { { corners[0], corners[1] },
      { corners[1], corners[2] }, { corners[2], corners[0] } } };
    if (std::none_of(
          sides.begin(), sides.end(), [&](const auto& side) { return taken.count(side) > 0; }))
    {
      taken.insert(sides.begin(), sides.end());
      kept.push_back(corners);
    }
  }
  Eigen::MatrixXi bridges(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i)
  {
    bridges.row(static_cast<Eigen::Index>(i)) << kept[i][0], kept[i][1], kept[i][2];
  }
  return bridges;
}

CrossedGaps RemoveGapBridges(int given, ImprintedCurves& split, std::vector<char>& isFeature,
  std::vector<std::vector<int>>& loops)
{
  std::vector<int> kept;
  std::vector<char> sides(split.Surface.Points.rows(), 0), remaining;
  std::set<std::pair<int, int>> edges, ofFeature; // directed
  constexpr char feature = 1, rest = 2, both = 3;
  for (int t = 0; t < static_cast<int>(isFeature.size()); ++t)
  {
    if (split.Provenance.Cells(t) >= given)
    {
      continue;
    }
    kept.push_back(t);
    remaining.push_back(isFeature[t]);
    for (int k = 0; k < 3; ++k)
    {
      const int a = split.Surface.Triangles(t, k), b = split.Surface.Triangles(t, (k + 1) % 3);
      sides[a] = static_cast<char>(sides[a] | (isFeature[t] != 0 ? feature : rest));
      edges.insert(std::minmax(a, b));
      if (isFeature[t] != 0)
      {
        ofFeature.insert({ a, b });
      }
    }
  }
  split.Surface.Triangles = split.Surface.Triangles(kept, Eigen::all).eval();
  split.Provenance.Cells = split.Provenance.Cells(kept).eval();
  isFeature = std::move(remaining);
  CrossedGaps gaps;
  for (std::vector<int>& loop : loops)
  {
    loop.erase(
      std::remove_if(loop.begin(), loop.end(), [&](int point) { return sides[point] != both; }),
      loop.end());
    if (loop.size() < 3)
    {
      throw InvalidInput("the loop lies in gaps between parts of the surface: only " +
        std::to_string(loop.size()) + " of its points are on triangles; draw it on the parts");
    }
    int leftMinusRight = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const int a = loop[i], b = loop[(i + 1) % loop.size()];
      leftMinusRight +=
        static_cast<int>(ofFeature.count({ a, b })) - static_cast<int>(ofFeature.count({ b, a }));
      if (edges.count(std::minmax(a, b)) == 0)
      {
        ++gaps.Count;
        gaps.Widest =
          std::max(gaps.Widest, (split.Surface.Points.row(a) - split.Surface.Points.row(b)).norm());
      }
    }
    if (leftMinusRight < 0)
    {
      std::reverse(loop.begin(), loop.end());
    }
  }
  return gaps;
}

} // namespace shape
