#include "Correspondence/CommonBase/Private/StripPaths.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace shape
{
namespace
{

/// Lengths next to a path count this many times.
constexpr double NearPath = 2.0;

/// The half-edges from a point of which each begins a triangle of the gap.
std::vector<int> SidesOf(const PathSurface& surface, const SurfaceGap& gap)
{
  const int first =
    gap.Neighbour < 0 ? surface.Leaving(gap.Point) : surface.Find(gap.Point, gap.Neighbour);
  std::vector<int> sides;
  int side = first;
  do
  {
    sides.push_back(side);
    side = surface.TurnLeft(side);
  } while (side != first && surface.PathOf(side) < 0);
  return sides;
}

/// A crossing of a half-edge from its own triangle to its twin's. Forms are the integrals from the
/// beginning of the path to the beginning of the half-edge.
struct Crossing
{
  int Side;
  int Before; ///< the previous crossing, or -1
  double Length;
  FormValues Forms;
};

/// The end of a path in the triangle of a half-edge that its last crossing enters.
struct Arrival
{
  int Target;
  int Side; ///< the half-edge from the target's point
};

class StripSearch
{
public:
  StripSearch(const PathSurface& surface, const SurfaceGap& from, const std::vector<SurfaceGap>& to,
    const AcceptForms& accept, double longest)
    : Searched(surface)
    , Accept(accept)
    , Longest(longest)
    , Open(to.size())
  {
    this->Found.resize(to.size());
    for (std::size_t i = 0; i < to.size(); ++i)
    {
      this->Found[i].Begin = from.Point;
      this->Found[i].End = to[i].Point;
      for (const int side : SidesOf(surface, to[i]))
      {
        this->Arrivals.emplace(
          surface.Twin(NextHalfEdge(side)), Arrival{ static_cast<int>(i), side });
      }
    }
    for (const int side : SidesOf(surface, from))
    {
      this->Start(side, to);
    }
    while (!this->Queue.empty() && this->Open > 0)
    {
      const auto [length, index, target] = this->Queue.top();
      this->Queue.pop();
      if (target >= 0)
      {
        this->Finish(length, index, target);
      }
      else if (const Crossing& crossing = this->Crossings[index];
               length <= this->Best.at(KeyOf(crossing.Side, crossing.Forms)))
      {
        this->Continue(index);
      }
    }
  }

  std::vector<StripPath> Found;

private:
  using Item = std::tuple<double, int, int>; // length, crossing, target or -1

  /// The largest integral: no short path turns around a handle more often.
  static constexpr int MaximumForm = 2;

  /// A number for a half-edge and the integrals up to it.
  static std::uint64_t KeyOf(int side, const FormValues& forms)
  {
    auto key = static_cast<std::uint64_t>(side);
    for (const int value : forms)
    {
      key = key * (2 * MaximumForm + 1) + static_cast<std::uint64_t>(value + MaximumForm);
    }
    return key;
  }

  /// The weight of a length between two half-edges.
  double WeightOf(int side) const
  {
    return this->Searched.IsOnPath(this->Searched.Begin(side)) ||
        this->Searched.IsOnPath(this->Searched.End(side))
      ? NearPath
      : 1.0;
  }

  void Push(int side, int before, double length, const FormValues& forms)
  {
    if (length > this->Longest || this->Searched.PathOf(side) >= 0 ||
      std::any_of(
        forms.begin(), forms.end(), [](int value) { return std::abs(value) > MaximumForm; }))
    {
      return;
    }
    const auto [position, isNew] = this->Best.try_emplace(KeyOf(side, forms), length);
    if (!isNew && position->second <= length)
    {
      return;
    }
    position->second = length;
    this->Crossings.push_back({ side, before, length, forms });
    this->Queue.emplace(length, static_cast<int>(this->Crossings.size()) - 1, -1);
  }

  void Start(int side, const std::vector<SurfaceGap>& to)
  {
    const PathSurface& surface = this->Searched;
    const int opposite = NextHalfEdge(side);
    const double length =
      (surface.Midpoint(opposite) - surface.PositionOf(surface.Begin(side))).norm();
    this->Push(opposite, -1, length * this->WeightOf(opposite), surface.FormsOf(side));
    if (surface.PathOf(side) >= 0 || this->Accept)
    {
      return;
    }
    for (std::size_t i = 0; i < to.size(); ++i)
    {
      const std::vector<int> sides =
        surface.End(side) == to[i].Point ? SidesOf(surface, to[i]) : std::vector<int>();
      if (std::find(sides.begin(), sides.end(), surface.Twin(side)) != sides.end())
      {
        this->Queue.emplace(surface.Length(side), -1, static_cast<int>(i));
      }
    }
  }

  void Continue(int index)
  {
    const PathSurface& surface = this->Searched;
    const Crossing crossing = this->Crossings[index];
    const Eigen::RowVector3d here = surface.Midpoint(crossing.Side);
    const auto [first, last] = this->Arrivals.equal_range(crossing.Side);
    for (auto arrival = first; arrival != last; ++arrival)
    {
      const int target = arrival->second.Target;
      // The third half-edge of the triangle begins where the crossed one does.
      const FormValues forms =
        AddForms(crossing.Forms, surface.FormsOf(PreviousHalfEdge(arrival->second.Side)));
      if (this->Found[target].Length < std::numeric_limits<double>::infinity() ||
        (this->Accept && !this->Accept(forms)))
      {
        continue;
      }
      const double length = (surface.PositionOf(surface.Begin(arrival->second.Side)) - here).norm();
      this->Queue.emplace(crossing.Length + length * this->WeightOf(crossing.Side), index, target);
    }
    // The triangle p q r is left for the triangle q p s: through p s or s q.
    const int entered = surface.Twin(crossing.Side);
    const int ps = NextHalfEdge(entered), sq = PreviousHalfEdge(entered);
    for (const int side : { ps, sq })
    {
      const FormValues forms =
        side == ps ? crossing.Forms : AddForms(crossing.Forms, surface.FormsOf(ps));
      const double length = (surface.Midpoint(side) - here).norm();
      this->Push(side, index, crossing.Length + length * this->WeightOf(side), forms);
    }
  }

  void Finish(double length, int index, int target)
  {
    StripPath& path = this->Found[target];
    if (path.Length < std::numeric_limits<double>::infinity())
    {
      return;
    }
    std::vector<int> sides;
    for (int at = index; at >= 0; at = this->Crossings[at].Before)
    {
      sides.push_back(this->Crossings[at].Side);
    }
    std::reverse(sides.begin(), sides.end());
    std::set<int> passed;
    for (const int side : sides)
    {
      passed.insert(side / 3);
    }
    if (!sides.empty())
    {
      passed.insert(this->Searched.Twin(sides.back()) / 3);
    }
    --this->Open;
    if (!sides.empty() && passed.size() != sides.size() + 1)
    {
      // A strip that passes a triangle twice.
      this->Found[target].Length = std::numeric_limits<double>::max();
      return;
    }
    path.Length = length;
    path.Sides = std::move(sides);
    if (!path.Sides.empty())
    {
      const int entered = this->Searched.Twin(path.Sides.back());
      // From p, where the crossed half-edge begins, to the point s.
      path.Forms =
        AddForms(this->Crossings[index].Forms, this->Searched.FormsOf(NextHalfEdge(entered)));
    }
  }

  const PathSurface& Searched;
  const AcceptForms& Accept;
  double Longest;
  std::size_t Open;
  std::vector<Crossing> Crossings;
  std::multimap<int, Arrival> Arrivals;
  std::unordered_map<std::uint64_t, double> Best;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> Queue;
};

/// The share of an edge at which a straight line in the unfolded strip crosses it.
double StraightShare(const Eigen::RowVector3d& before, const Eigen::RowVector3d& after,
  const Eigen::RowVector3d& begin, const Eigen::RowVector3d& end)
{
  // Splits near the ends of edges would make slivers.
  constexpr double margin = 0.2;
  const Eigen::RowVector3d edge = end - begin;
  const double square = edge.squaredNorm();
  const auto along = [&](const Eigen::RowVector3d& p) { return (p - begin).dot(edge) / square; };
  const auto height = [&](const Eigen::RowVector3d& p)
  { return (p - begin - along(p) * edge).norm(); };
  const double a = height(before), b = height(after);
  const double share = a + b > 0.0 ? (along(before) * b + along(after) * a) / (a + b) : 0.5;
  return std::clamp(share, margin, 1.0 - margin);
}

} // namespace

std::vector<StripPath> FindStripPaths(const PathSurface& surface, const SurfaceGap& from,
  const std::vector<SurfaceGap>& to, const AcceptForms& accept, double longest)
{
  std::vector<StripPath> found = StripSearch(surface, from, to, accept, longest).Found;
  for (StripPath& path : found)
  {
    if (path.Length == std::numeric_limits<double>::max())
    {
      path.Length = std::numeric_limits<double>::infinity();
    }
  }
  return found;
}

std::vector<int> ImprintStripPath(PathSurface& surface, const StripPath& path, int number)
{
  struct Edge
  {
    int From, To;
    double Share;
  };
  std::vector<Edge> edges;
  for (const int side : path.Sides)
  {
    edges.push_back({ surface.Begin(side), surface.End(side), 0.5 });
  }
  const auto positionAt = [&](int i) -> Eigen::RowVector3d
  {
    if (i < 0 || i == static_cast<int>(edges.size()))
    {
      return surface.PositionOf(i < 0 ? path.Begin : path.End);
    }
    const Edge& edge = edges[i];
    return (1.0 - edge.Share) * surface.PositionOf(edge.From) +
      edge.Share * surface.PositionOf(edge.To);
  };
  constexpr int sweeps = 20; // enough for the path to look straight
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (int i = 0; i < static_cast<int>(edges.size()); ++i)
    {
      edges[i].Share = StraightShare(positionAt(i - 1), positionAt(i + 1),
        surface.PositionOf(edges[i].From), surface.PositionOf(edges[i].To));
    }
  }
  std::vector<int> points{ path.Begin };
  int side = path.Sides.empty() ? -1 : path.Sides.front();
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (i > 0)
    {
      // Opposite the last point lies the next edge, in one of the triangles made by the split.
      int leaving = surface.Leaving(points.back());
      while (surface.End(leaving) != edges[i].From || surface.Apex(leaving) != edges[i].To)
      {
        leaving = surface.TurnLeft(leaving);
      }
      side = NextHalfEdge(leaving);
    }
    const int point = surface.Split(side, edges[i].Share);
    surface.Mark(surface.Find(points.back(), point), number);
    points.push_back(point);
  }
  surface.Mark(surface.Find(points.back(), path.End), number);
  points.push_back(path.End);
  return points;
}

} // namespace shape
