#include "Labels/Private/TouchingRegions.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace shape
{
namespace
{

using Corners = std::array<int, 3>;

/// A triangle and the regions that its normal leaves and enters.
struct Facet
{
  Corners Points;
  int Left, Entered;
};

/// The share of the way from the old point to the mean of the fan's border.
constexpr double NewPosition = 0.25;

/// The triangles around the candidates, which splits change, and the points.
class Splitter
{
public:
  Splitter(Eigen::MatrixXd& points, std::vector<Facet>& facets, const std::vector<int>& candidates)
    : Facets(facets)
  {
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      this->Points.push_back(points.row(i));
    }
    for (const int candidate : candidates)
    {
      this->Around[candidate];
    }
    for (std::size_t f = 0; f < facets.size(); ++f)
    {
      this->Register(static_cast<int>(f));
    }
  }

  int SplitAll(const std::vector<int>& candidates)
  {
    const auto before = this->Points.size();
    std::vector<int> waiting = candidates;
    while (!waiting.empty())
    {
      const int point = waiting.back();
      waiting.pop_back();
      for (const std::vector<int>& fan : this->FindFans(point))
      {
        const Ring ring = this->FindRing(point, fan);
        if (ring.IsManifold())
        {
          waiting.push_back(point);
          waiting.push_back(this->Split(point, ring));
          break;
        }
      }
    }
    return static_cast<int>(this->Points.size() - before);
  }

  std::vector<Eigen::RowVector3d> Points;

private:
  void Register(int facet)
  {
    for (const int corner : this->Facets[facet].Points)
    {
      const auto known = this->Around.find(corner);
      if (known != this->Around.end())
      {
        known->second.insert(facet);
      }
    }
  }

  void Unregister(int facet)
  {
    for (const int corner : this->Facets[facet].Points)
    {
      const auto known = this->Around.find(corner);
      if (known != this->Around.end())
      {
        known->second.erase(facet);
      }
    }
  }

  /// The corners after and before a point in a triangle.
  std::array<int, 2> Others(int facet, int point) const
  {
    const Corners& corners = this->Facets[facet].Points;
    const auto at = std::find(corners.begin(), corners.end(), point) - corners.begin();
    return { corners[(at + 1) % 3], corners[(at + 2) % 3] };
  }

  /// The ring of a fan around a point: its border and the triangles beside it.
  struct Ring
  {
    std::set<int> Border;
    std::vector<int> Moved; ///< triangles with a corner on the border: they go to the new point
    /// New triangles (old point, new point, q) by q.
    std::map<int, Facet> Halves;

    /// Whether each region surrounds the edge between the old and the new point at most once.
    bool IsManifold() const
    {
      std::map<int, int> sides;
      for (const auto& [q, half] : this->Halves)
      {
        ++sides[half.Left];
        ++sides[half.Entered];
      }
      return std::all_of(
        sides.begin(), sides.end(), [](const auto& side) { return side.second == 2; });
    }
  };

  std::vector<std::vector<int>> FindFans(int point) const;
  Ring FindRing(int point, const std::vector<int>& fan) const;
  int Split(int point, const Ring& ring);

  std::vector<Facet>& Facets;
  std::map<int, std::set<int>> Around;
};

/// Returns the fans of the regions that have several at a point, the smallest first.
std::vector<std::vector<int>> Splitter::FindFans(int point) const
{
  std::map<int, std::vector<int>> ofRegion;
  for (const int facet : this->Around.at(point))
  {
    ofRegion[this->Facets[facet].Left].push_back(facet);
    ofRegion[this->Facets[facet].Entered].push_back(facet);
  }
  std::vector<std::vector<int>> all;
  for (const auto& [region, facets] : ofRegion)
  {
    std::vector<std::vector<int>> fans;
    std::set<int> left(facets.begin(), facets.end());
    while (!left.empty())
    {
      std::vector<int> fan = { *left.begin() };
      left.erase(left.begin());
      std::set<int> border;
      for (std::size_t i = 0; i < fan.size(); ++i)
      {
        const std::array<int, 2> ends = this->Others(fan[i], point);
        border.insert(ends.begin(), ends.end());
        for (auto next = left.begin(); next != left.end();)
        {
          const std::array<int, 2> other = this->Others(*next, point);
          const bool isConnected = border.count(other[0]) || border.count(other[1]);
          if (isConnected)
          {
            fan.push_back(*next);
          }
          next = isConnected ? left.erase(next) : std::next(next);
        }
      }
      fans.push_back(fan);
    }
    if (fans.size() > 1)
    {
      all.insert(all.end(), fans.begin(), fans.end());
    }
  }
  std::stable_sort(
    all.begin(), all.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  return all;
}

Splitter::Ring Splitter::FindRing(int point, const std::vector<int>& fan) const
{
  Ring ring;
  for (const int facet : fan)
  {
    const std::array<int, 2> ends = this->Others(facet, point);
    ring.Border.insert(ends.begin(), ends.end());
  }
  // A triangle with one corner on the border becomes two. Several may have the same second half:
  // regions between them end there.
  struct Sides
  {
    std::multiset<int> Left, Entered;
  };
  std::map<int, Sides> halves;
  for (const int facet : this->Around.at(point))
  {
    const auto [next, previous] = this->Others(facet, point);
    const bool isNextOn = ring.Border.count(next) > 0;
    const bool isPreviousOn = ring.Border.count(previous) > 0;
    const Facet& given = this->Facets[facet];
    if (isNextOn && !isPreviousOn)
    {
      halves[previous].Left.insert(given.Left);
      halves[previous].Entered.insert(given.Entered);
    }
    else if (isPreviousOn && !isNextOn)
    {
      halves[next].Left.insert(given.Entered);
      halves[next].Entered.insert(given.Left);
    }
    if (isNextOn || isPreviousOn)
    {
      ring.Moved.push_back(facet);
    }
  }
  const int added = static_cast<int>(this->Points.size());
  for (auto& [q, sides] : halves)
  {
    for (auto region = sides.Left.begin(); region != sides.Left.end();)
    {
      const auto same = sides.Entered.find(*region);
      const bool isBetween = same != sides.Entered.end();
      if (isBetween)
      {
        sides.Entered.erase(same);
      }
      region = isBetween ? sides.Left.erase(region) : std::next(region);
    }
    if (!sides.Left.empty())
    {
      const int left = *sides.Left.begin(), entered = *sides.Entered.begin();
      ring.Halves[q] = { left > entered ? Corners{ point, added, q } : Corners{ added, point, q },
        std::max(left, entered), std::min(left, entered) };
    }
  }
  return ring;
}

/// Moves a fan to a new point and returns that point.
int Splitter::Split(int point, const Ring& ring)
{
  Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
  for (const int end : ring.Border)
  {
    mean += this->Points[end] / static_cast<double>(ring.Border.size());
  }
  const int added = static_cast<int>(this->Points.size());
  this->Points.push_back((1.0 - NewPosition) * this->Points[point] + NewPosition * mean);
  this->Around[added];
  for (const int facet : ring.Moved)
  {
    Corners& corners = this->Facets[facet].Points;
    this->Unregister(facet);
    std::replace(corners.begin(), corners.end(), point, added);
    this->Register(facet);
  }
  for (const auto& [q, half] : ring.Halves)
  {
    this->Facets.push_back(half);
    this->Register(static_cast<int>(this->Facets.size()) - 1);
  }
  return added;
}

} // namespace

int SplitTouchingRegions(Eigen::MatrixXd& points, Eigen::MatrixXi& triangles,
  Eigen::MatrixXi& regions, const std::vector<int>& candidates)
{
  std::vector<Facet> facets;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    facets.push_back(
      { { triangles(t, 0), triangles(t, 1), triangles(t, 2) }, regions(t, 0), regions(t, 1) });
  }
  Splitter splitter(points, facets, candidates);
  const int added = splitter.SplitAll(candidates);
  if (added == 0)
  {
    return 0;
  }
  points.resize(static_cast<Eigen::Index>(splitter.Points.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) = splitter.Points[i];
  }
  triangles.resize(static_cast<Eigen::Index>(facets.size()), 3);
  regions.resize(triangles.rows(), 2);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const Facet& facet = facets[t];
    triangles.row(t) << facet.Points[0], facet.Points[1], facet.Points[2];
    regions.row(t) << facet.Left, facet.Entered;
  }
  return added;
}

} // namespace shape
