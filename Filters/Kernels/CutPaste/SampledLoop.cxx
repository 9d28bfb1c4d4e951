#include "CutPaste/SampledLoop.h"

#include "Base/Errors.h"
#include "Geometry/SegmentProjection.h"
#include "Search/PointTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

Graph LinkSamples(const Mesh& surface)
{
  std::vector<std::pair<int, int>> links;
  for (const auto& corners : surface.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      links.emplace_back(corners(k), corners((k + 1) % 3));
    }
  }
  return BuildGraph(surface.Points, std::move(links));
}

double DistanceFromLine(const RowVector2d& point, const RowVector2d& end)
{
  const double share = ProjectOntoSegment(point, RowVector2d::Zero(), end);
  return (point - share * end).norm();
}

/// Leaves out the shorter part of a closed walk wherever it passes through a node twice.
std::vector<int> MakeSimple(const std::vector<int>& walk)
{
  std::vector<int> loop;
  for (std::size_t i = 0; i < walk.size(); ++i)
  {
    const auto before = std::find(loop.begin(), loop.end(), walk[i]);
    if (before == loop.end())
    {
      loop.push_back(walk[i]);
      continue;
    }
    const auto part = static_cast<std::size_t>(loop.end() - before);
    if (2 * part > walk.size())
    {
      return { before, loop.end() };
    }
    loop.erase(before + 1, loop.end());
  }
  return loop;
}

void RequireThree(std::size_t count)
{
  if (count < 3)
  {
    throw InvalidInput("the loop passes through " + std::to_string(count) +
      " points of the cloud, and needs at least 3; draw a wider loop, or use a denser cloud");
  }
}

/// The plane of one link of a loop, in which neighbours are compared.
struct LinkPlane
{
  RowVector3d Origin, X, Y;

  LinkPlane(const Eigen::MatrixXd& points, int from, int to, const RowVector3d& normal)
    : Origin(points.row(from))
    , X((points.row(to) - points.row(from)).normalized())
    , Y(normal.cross(X).normalized())
  {
  }
  RowVector2d Flatten(const RowVector3d& point) const
  {
    const RowVector3d away = point - this->Origin;
    return { away.dot(this->X), away.dot(this->Y) };
  }
};

double Cross(const RowVector2d& a, const RowVector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

bool DoCross(const RowVector2d& a, const RowVector2d& b, const RowVector2d& c, const RowVector2d& d)
{
  return Cross(b - a, c - a) * Cross(b - a, d - a) < 0.0 &&
    Cross(d - c, a - c) * Cross(d - c, b - c) < 0.0;
}

/// Whether a direction is to the left of a bend, which comes along `in` and leaves along `out`.
bool IsLeft(const RowVector2d& in, const RowVector2d& out, const RowVector2d& direction)
{
  const auto angleFrom = [&](const RowVector2d& other)
  {
    const double angle = std::atan2(Cross(out, other), out.dot(other));
    return angle < 0.0 ? angle + 2.0 * M_PI : angle;
  };
  return angleFrom(direction) < angleFrom(-in);
}

/// The components of the samples that links connect without passing the loop, and how many of
/// their links to the loop end on its left.
class LoopFlood
{
public:
  LoopFlood(const SampledSurface& samples, const Graph& links, const std::vector<int>& loop)
    : Samples(samples)
    , Links(links)
    , Loop(loop)
    , IsOnLoop(samples.Surface.Points.rows(), 0)
    , ComponentOf(samples.Surface.Points.rows(), -1)
  {
    for (const int point : loop)
    {
      this->IsOnLoop[point] = 1;
    }
    this->FindCrossings();
    this->Flood();
    this->Count();
  }

  std::vector<int> ComponentOfSamples() const { return this->ComponentOf; }
  std::vector<std::array<int, 2>> LeftAndRight; ///< of each component

private:
  RowVector3d At(int point) const { return this->Samples.Surface.Points.row(point); }
  RowVector3d NormalAt(int point) const { return this->Samples.Normals.row(point); }

  std::vector<int> NeighboursOf(int point) const
  {
    std::vector<int> found;
    for (int k = this->Links.First[point]; k < this->Links.First[point + 1]; ++k)
    {
      if (this->IsOnLoop[this->Links.Neighbours[k]] == 0)
      {
        found.push_back(this->Links.Neighbours[k]);
      }
    }
    return found;
  }

  void FindCrossings()
  {
    const std::size_t size = this->Loop.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      const int from = this->Loop[i], to = this->Loop[(i + 1) % size];
      const LinkPlane plane(
        this->Samples.Surface.Points, from, to, this->NormalAt(from) + this->NormalAt(to));
      const RowVector2d end = plane.Flatten(this->At(to));
      for (const int side : { from, to })
      {
        for (const int a : this->NeighboursOf(side))
        {
          for (const int b : this->NeighboursOf(a))
          {
            if (DoCross(
                  RowVector2d::Zero(), end, plane.Flatten(this->At(a)), plane.Flatten(this->At(b))))
            {
              this->Crossing.insert(std::minmax(a, b));
            }
          }
        }
      }
    }
  }

  void Flood()
  {
    for (int start = 0; start < this->Links.Size(); ++start)
    {
      if (this->IsOnLoop[start] != 0 || this->ComponentOf[start] >= 0)
      {
        continue;
      }
      const auto number = static_cast<int>(this->LeftAndRight.size());
      this->LeftAndRight.push_back({ 0, 0 });
      std::vector<int> left{ start };
      this->ComponentOf[start] = number;
      while (!left.empty())
      {
        const int next = left.back();
        left.pop_back();
        for (const int other : this->NeighboursOf(next))
        {
          if (this->ComponentOf[other] < 0 && this->Crossing.count(std::minmax(next, other)) == 0)
          {
            this->ComponentOf[other] = number;
            left.push_back(other);
          }
        }
      }
    }
  }

  void Count()
  {
    const std::size_t size = this->Loop.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      const int here = this->Loop[i], next = this->Loop[(i + 1) % size],
                before = this->Loop[(i + size - 1) % size];
      const LinkPlane plane(this->Samples.Surface.Points, here, next, this->NormalAt(here));
      const RowVector2d in = -plane.Flatten(this->At(before)), out = plane.Flatten(this->At(next));
      for (const int other : this->NeighboursOf(here))
      {
        const bool isLeft = IsLeft(in, out, plane.Flatten(this->At(other)));
        ++this->LeftAndRight[this->ComponentOf[other]][isLeft ? 0 : 1];
      }
    }
  }

  const SampledSurface& Samples;
  const Graph& Links;
  const std::vector<int>& Loop;
  std::vector<char> IsOnLoop;
  std::vector<int> ComponentOf;
  std::set<std::pair<int, int>> Crossing; ///< links between the two sides
};

/// The area around each sample.
Eigen::VectorXd AreasOf(const SampledSurface& samples)
{
  const Eigen::VectorXd areas =
    0.5 * ComputeAreaVectors(samples.Surface).rowwise().norm().cwiseProduct(samples.Shares);
  Eigen::VectorXd around = Eigen::VectorXd::Zero(samples.Surface.Points.rows());
  for (Eigen::Index t = 0; t < areas.size(); ++t)
  {
    for (const int corner : samples.Surface.Triangles.row(t))
    {
      around(corner) += areas(t) / 3.0;
    }
  }
  return around;
}

} // namespace

SampledLoops::SampledLoops(const SampledSurface& samples, const Progress& progress)
  : Samples(samples)
  , Links(LinkSamples(samples.Surface))
  , Map(samples, {}, progress)
  , MeanLink(ComputeSpacing(samples))
{
}

std::vector<int> SampledLoops::PathBetween(int from, int to, const Progress& progress)
{
  const RowVector3d start = this->Samples.Surface.Points.row(from);
  double radius = 1.5 * (this->Samples.Surface.Points.row(to) - start).norm();
  std::size_t reached = 0;
  while (true)
  {
    const ExponentialPatch patch =
      this->Map.Around(start, radius, RowVector3d::Zero(), -1, progress);
    std::vector<int> rows(this->Samples.Surface.Points.rows(), -1);
    for (std::size_t i = 0; i < patch.Points.size(); ++i)
    {
      rows[patch.Points[i]] = static_cast<int>(i);
    }
    if (rows[to] < 0)
    {
      if (patch.Points.size() == reached)
      {
        throw InvalidInput("no links connect points " + std::to_string(from) + " and " +
          std::to_string(to) +
          " of the loop: the gap between them is wider than the neighbourhoods of the points; draw "
          "the loop on one part");
      }
      reached = patch.Points.size();
      radius *= 2.0;
      continue;
    }
    const RowVector2d end = patch.Positions.row(rows[to]);
    const auto distanceOf = [&](int point)
    { return DistanceFromLine(patch.Positions.row(rows[point]), end) / this->MeanLink; };
    return FindShortestPath(this->Links, from, to,
      [&](double distance, int k)
      {
        const int next = this->Links.Neighbours[k];
        if (rows[next] < 0)
        {
          return std::numeric_limits<double>::infinity();
        }
        const double away = distanceOf(next);
        return distance + this->Links.Lengths[k] * (1.0 + away * away);
      });
  }
}

std::vector<int> SampledLoops::Trace(const Eigen::MatrixXd& curve, const Progress& progress)
{
  RequireFinite(curve, "the loop");
  const PointTree tree(this->Samples.Surface.Points);
  std::vector<int> stops;
  for (const auto& position : curve.rowwise())
  {
    const int nearest = tree.Nearest(position, 1).front();
    if (stops.empty() || stops.back() != nearest)
    {
      stops.push_back(nearest);
    }
  }
  if (stops.size() > 1 && stops.front() == stops.back())
  {
    stops.pop_back();
  }
  RequireThree(stops.size());
  std::vector<int> walk;
  for (std::size_t i = 0; i < stops.size(); ++i)
  {
    const auto count = static_cast<double>(stops.size());
    const std::vector<int> path = this->PathBetween(stops[i], stops[(i + 1) % stops.size()],
      progress.Part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
    walk.insert(walk.end(), path.begin(), path.end() - 1);
  }
  std::vector<int> loop = MakeSimple(walk);
  RequireThree(loop.size());
  return loop;
}

std::vector<char> SampledLoops::MarkSide(const std::vector<int>& loop, LoopSide side) const
{
  const LoopFlood flood(this->Samples, this->Links, loop);
  const std::vector<int> components = flood.ComponentOfSamples();
  // A component is on the side of nearly all of its links to the loop. Where the local triangles
  // of a sparse sampling disagree, a few may be on the other one.
  constexpr double nearlyAll = 0.9;
  std::vector<int> sides(flood.LeftAndRight.size(), -1);
  for (std::size_t c = 0; c < sides.size(); ++c)
  {
    const auto [left, right] = flood.LeftAndRight[c];
    if (left + right == 0)
    {
      continue;
    }
    if (std::max(left, right) < nearlyAll * (left + right))
    {
      throw InvalidInput("the loop does not divide the points: its two sides are connected, as "
                         "around a handle; draw the loop around the feature");
    }
    sides[c] = left > right ? 0 : 1;
  }
  const Eigen::VectorXd areas = AreasOf(this->Samples);
  std::array<double, 2> sum = { 0.0, 0.0 };
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    if (components[i] >= 0 && sides[components[i]] >= 0)
    {
      sum[sides[components[i]]] += areas(static_cast<Eigen::Index>(i));
    }
  }
  const bool isLeftSmaller = sum[0] <= sum[1];
  const int wanted = side == LoopSide::Left || (side == LoopSide::Smaller && isLeftSmaller) ||
      (side == LoopSide::Larger && !isLeftSmaller)
    ? 0
    : 1;
  std::vector<char> marks(components.size(), 0);
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    marks[i] = components[i] >= 0 && sides[components[i]] == wanted ? 1 : 0;
  }
  if (std::none_of(marks.begin(), marks.end(), [](char mark) { return mark != 0; }))
  {
    throw InvalidInput("the loop encloses no point; draw a wider loop, or change Side");
  }
  return marks;
}

} // namespace shape
