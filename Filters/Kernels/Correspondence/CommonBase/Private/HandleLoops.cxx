#include "Correspondence/CommonBase/Private/HandleLoops.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

/// A path from the first point of a search.
struct SearchedPath
{
  int Point;        ///< its end
  int Before;       ///< the path without its last edge, or -1
  double Length;    ///< in the model's units
  FormValues Forms; ///< the integrals of the surface's forms
};

/// The shortest paths from a point to each point, of up to `classes` classes each.
struct PathSearch
{
  std::vector<SearchedPath> Paths;
  std::vector<std::vector<int>> AtPoint; ///< for each point, its paths, the shortest first

  PathSearch(const PathSurface& surface, int from, int classes);
  /// Returns the points of a path, from its end.
  std::vector<int> PointsOf(int path) const
  {
    std::vector<int> points;
    for (int i = path; i >= 0; i = this->Paths[i].Before)
    {
      points.push_back(this->Paths[i].Point);
    }
    return points;
  }
};

PathSearch::PathSearch(const PathSurface& surface, int from, int classes)
  : AtPoint(surface.PointCount())
{
  using Item = std::tuple<double, int, FormValues, int>; // length, point, forms, path before
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  queue.emplace(0.0, from, FormValues{}, -1);
  while (!queue.empty())
  {
    const auto [length, point, forms, before] = queue.top();
    queue.pop();
    std::vector<int>& known = this->AtPoint[point];
    const bool isKnown = std::any_of(known.begin(), known.end(),
      [&, &values = forms](int path) { return this->Paths[path].Forms == values; });
    if (isKnown || static_cast<int>(known.size()) == classes)
    {
      continue;
    }
    const auto path = static_cast<int>(this->Paths.size());
    known.push_back(path);
    this->Paths.push_back({ point, before, length, forms });
    const int first = surface.Leaving(point);
    int side = first;
    do
    {
      queue.emplace(length + surface.Length(side), surface.End(side),
        AddForms(forms, surface.FormsOf(side)), path);
      side = surface.TurnLeft(side);
    } while (side != first);
  }
}

} // namespace

SurfaceCycle Reversed(const SurfaceCycle& cycle)
{
  SurfaceCycle reversed = cycle;
  std::reverse(reversed.Points.begin() + 1, reversed.Points.end());
  reversed.Homology = -cycle.Homology;
  return reversed;
}

std::array<LoopCrossing, 4> Turned(const LoopCrossing& crossing)
{
  const SurfaceCycle handle = Reversed(crossing.Handle), tunnel = Reversed(crossing.Tunnel);
  return { { crossing, { handle, tunnel }, { handle, crossing.Tunnel },
    { crossing.Handle, tunnel } } };
}

HandleLoops::HandleLoops(const Surface& surface, const std::string& name)
  : Traced{ PathSurface(surface), name, {}, std::sqrt(ComputeArea(surface)) }
{
  this->Traced.Basis = FindHomologyBasis(this->Traced.Surface, {}, name);
}

std::vector<SurfaceCycle> HandleLoops::CyclesAt(int point) const
{
  const PathSurface& surface = this->Traced.Surface;
  constexpr int classes = 3; // of paths to each point
  const PathSearch search(surface, point, classes);
  // For each class, up to its sign: the shortest loop, its edge and the paths to both ends.
  using Found = std::tuple<double, int, int>;
  std::map<FormValues, Found> shortest;
  for (int side = 0; side < surface.SideCount(); ++side)
  {
    for (const int there : search.AtPoint[surface.Begin(side)])
    {
      for (const int back : search.AtPoint[surface.End(side)])
      {
        const SearchedPath &one = search.Paths[there], &other = search.Paths[back];
        const FormValues forms =
          AddForms(AddForms(one.Forms, surface.FormsOf(side)), other.Forms, -1);
        const auto sign = std::find_if(forms.begin(), forms.end(), [](int x) { return x != 0; });
        if (sign == forms.end() || *sign < 0)
        {
          continue; // the twin half-edge closes the loop in the other direction
        }
        const Found found{ one.Length + surface.Length(side) + other.Length, there, back };
        const auto [known, isNew] = shortest.emplace(forms, found);
        known->second = std::min(known->second, found);
      }
    }
  }
  std::vector<SurfaceCycle> cycles;
  for (const auto& [forms, found] : shortest)
  {
    const auto& [length, there, back] = found;
    std::vector<int> points = search.PointsOf(there);
    std::reverse(points.begin(), points.end());
    std::vector<int> second = search.PointsOf(back);
    points.insert(points.end(), second.begin(), second.end() - 1);
    const bool isSimple =
      std::set<int>(points.begin(), points.end()).size() == points.size() && points.size() > 2;
    SurfaceCycle cycle{ std::move(points), length, this->Traced.HomologyOf(forms) };
    if (isSimple)
    {
      cycles.push_back(std::move(cycle));
    }
  }
  std::sort(cycles.begin(), cycles.end(),
    [](const SurfaceCycle& a, const SurfaceCycle& b)
    { return std::tie(a.Length, a.Points) < std::tie(b.Length, b.Points); });
  return cycles;
}

std::vector<LoopCrossing> HandleLoops::FindAt(int point, int count) const
{
  std::vector<SurfaceCycle> handles, tunnels;
  for (const SurfaceCycle& cycle : this->CyclesAt(point))
  {
    if (this->Traced.Bounds(cycle.Homology, true))
    {
      handles.push_back(cycle);
    }
    else if (this->Traced.Bounds(cycle.Homology, false))
    {
      tunnels.push_back(cycle);
    }
  }
  std::vector<LoopCrossing> crossings;
  for (const SurfaceCycle& handle : handles)
  {
    for (const SurfaceCycle& tunnel : tunnels)
    {
      if (std::abs(this->Crossings(handle, tunnel)) == 1)
      {
        crossings.push_back({ handle, tunnel });
      }
    }
  }
  std::sort(crossings.begin(), crossings.end(),
    [](const LoopCrossing& a, const LoopCrossing& b)
    {
      return std::make_tuple(a.Length(), std::cref(a.Handle.Points), std::cref(a.Tunnel.Points)) <
        std::make_tuple(b.Length(), std::cref(b.Handle.Points), std::cref(b.Tunnel.Points));
    });
  if (static_cast<int>(crossings.size()) > count)
  {
    crossings.resize(count);
  }
  return crossings;
}

} // namespace shape
