#include "Mesh/BoundaryLoops.h"

#include "Base/Errors.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

namespace shape
{
namespace
{

constexpr int None = -1;
constexpr int Tangled = -2;

/// The half-edges of triangles, and their twins. Find walks along the boundary from each of its
/// half-edges (Walk, Next), splits the chain into simple loops (Split, Add) and sorts these (Sort).
class BoundaryWalk
{
public:
  explicit BoundaryWalk(const Mesh& surface)
    : Surface(surface)
    , Position(FindCoincidentPoints(surface.Points))
    , Twins(3 * surface.Triangles.rows(), Tangled)
    , Used(this->Twins.size(), false)
  {
    std::vector<int> sides;
    for (int t = 0; t < static_cast<int>(surface.Triangles.rows()); ++t)
    {
      const Eigen::RowVector3i c = surface.Triangles.row(t);
      if (c(0) != c(1) && c(1) != c(2) && c(2) != c(0))
      {
        sides.insert(sides.end(), { 3 * t, 3 * t + 1, 3 * t + 2 });
      }
    }
    this->FindTwins(sides, [&](int side) { return this->Begin(side); });
    // Seams whose points are duplicated.
    sides.erase(std::remove_if(
                  sides.begin(), sides.end(), [&](int side) { return this->Twins[side] != None; }),
      sides.end());
    this->FindTwins(sides, [&](int side) { return this->BeginPosition(side); });
  }

  BoundaryLoops Find()
  {
    BoundaryLoops boundary;
    std::vector<int> open;
    for (int side = 0; side < static_cast<int>(this->Twins.size()); ++side)
    {
      if (this->Twins[side] == None)
      {
        this->Leaving[this->BeginPosition(side)].push_back(side);
        open.push_back(side);
      }
    }
    for (const int side : open)
    {
      if (!this->Used[side])
      {
        this->Split(this->Walk(side), boundary);
      }
    }
    this->Sort(boundary.Loops);
    return boundary;
  }

private:
  int Begin(int side) const { return this->Surface.Triangles(side / 3, side % 3); }
  int End(int side) const { return this->Begin(NextHalfEdge(side)); }
  int BeginPosition(int side) const { return this->Position[this->Begin(side)]; }
  int EndPosition(int side) const { return this->Position[this->End(side)]; }

  /// Among half-edges between the same two points, two of opposite direction are twins. A single
  /// one is on the boundary. The twins of the others are undefined.
  template <typename PointOf>
  void FindTwins(const std::vector<int>& sides, const PointOf& pointOf)
  {
    struct Ends
    {
      int Low, High, Side;
      bool operator<(const Ends& other) const
      {
        return this->High != other.High ? this->High < other.High : this->Side < other.Side;
      }
    };
    // Few share their lower point, so a counting pass makes the sort fast.
    std::vector<int> first(this->Position.size() + 1, 0);
    const auto endsOf = [&](int side)
    {
      const int begin = pointOf(side), end = pointOf(NextHalfEdge(side));
      return Ends{ std::min(begin, end), std::max(begin, end), side };
    };
    for (const int side : sides)
    {
      ++first[endsOf(side).Low + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Ends> ends(sides.size());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (const int side : sides)
    {
      const Ends is = endsOf(side);
      ends[next[is.Low]++] = is;
    }
    for (std::size_t low = 0; low + 1 < first.size(); ++low)
    {
      std::sort(ends.begin() + first[low], ends.begin() + first[low + 1]);
    }
    for (std::size_t i = 0, end = 0; i < ends.size(); i = end)
    {
      while (end < ends.size() && ends[end].Low == ends[i].Low && ends[end].High == ends[i].High)
      {
        ++end;
      }
      const int side = ends[i].Side, other = end - i == 2 ? ends[i + 1].Side : side;
      if (end - i == 1)
      {
        this->Twins[side] = None;
      }
      else if (end - i == 2 && pointOf(side) != pointOf(other))
      {
        this->Twins[side] = other;
        this->Twins[other] = side;
      }
      else if (ends[i].Low != ends[i].High)
      {
        for (std::size_t k = i; k < end; ++k)
        {
          this->Twins[ends[k].Side] = Tangled;
        }
      }
    }
  }

  /// Returns the next boundary half-edge: around the same fan of triangles or, if that is
  /// ambiguous, the first one left at the position; None if there is none.
  int Next(int side)
  {
    int next = NextHalfEdge(side);
    while (this->Twins[next] >= 0)
    {
      next = NextHalfEdge(this->Twins[next]);
    }
    if (this->Twins[next] == None && !this->Used[next])
    {
      return next;
    }
    for (const int other : this->Leaving[this->EndPosition(side)])
    {
      if (!this->Used[other])
      {
        return other;
      }
    }
    return None;
  }

  std::vector<int> Walk(int first)
  {
    std::vector<int> chain;
    for (int side = first; side != None; side = this->Next(side))
    {
      this->Used[side] = true;
      chain.push_back(side);
    }
    return chain;
  }

  /// Extracts from a chain the closed loops that contain no position twice.
  void Split(const std::vector<int>& chain, BoundaryLoops& boundary)
  {
    std::vector<int> open;                // half-edges
    std::unordered_map<int, int> visited; // position -> index in `open` of a half-edge from it
    for (const int side : chain)
    {
      visited.try_emplace(this->BeginPosition(side), static_cast<int>(open.size()));
      open.push_back(side);
      const auto position = visited.find(this->EndPosition(side));
      if (position == visited.end() || this->EndPosition(side) == this->BeginPosition(side))
      {
        continue;
      }
      const int begin = position->second;
      const std::vector<int> sides(open.begin() + begin, open.end());
      open.resize(begin);
      for (const int closed : sides)
      {
        visited.erase(this->BeginPosition(closed));
      }
      this->Add(sides, boundary);
    }
    boundary.UnclosedSides += static_cast<int>(open.size());
  }

  /// Adds half-edges that form a closed loop; both of two duplicated points are part of it.
  void Add(const std::vector<int>& sides, BoundaryLoops& boundary) const
  {
    std::vector<int> loop;
    std::set<int> positions;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      loop.push_back(this->Begin(sides[i]));
      positions.insert(this->BeginPosition(sides[i]));
      if (this->End(sides[i]) != this->Begin(sides[(i + 1) % sides.size()]))
      {
        loop.push_back(this->End(sides[i]));
      }
    }
    if (positions.size() < 3)
    {
      boundary.UnclosedSides += static_cast<int>(sides.size());
      return;
    }
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    boundary.Loops.push_back(std::move(loop));
  }

  void Sort(std::vector<std::vector<int>>& loops) const
  {
    std::vector<std::pair<double, std::vector<int>>> byLength;
    for (std::vector<int>& loop : loops)
    {
      double length = 0.0;
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        length += (this->Surface.Points.row(loop[(i + 1) % loop.size()]) -
          this->Surface.Points.row(loop[i]))
                    .norm();
      }
      byLength.emplace_back(-length, std::move(loop));
    }
    std::sort(byLength.begin(), byLength.end());
    std::transform(byLength.begin(), byLength.end(), loops.begin(),
      [](std::pair<double, std::vector<int>>& loop) { return std::move(loop.second); });
  }

  const Mesh& Surface;
  std::vector<int> Position;                         ///< the position of each point
  std::vector<int> Twins;                            ///< the twin of each half-edge
  std::vector<bool> Used;                            ///< whether each half-edge is in a chain
  std::unordered_map<int, std::vector<int>> Leaving; ///< position -> boundary half-edges from it
};

double ComputeLoopLength(const std::vector<int>& loop, const Eigen::MatrixXd& points)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += (points.row(loop[(i + 1) % loop.size()]) - points.row(loop[i])).norm();
  }
  return length;
}

} // namespace

BoundaryLoops FindBoundaryLoops(const Mesh& surface)
{
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    if (surface.Triangles.row(t).minCoeff() < 0 ||
      surface.Triangles.row(t).maxCoeff() >= surface.Points.rows())
    {
      throw InvalidInput("triangle " + std::to_string(t) + " uses a point that does not exist; " +
        "the surface has " + std::to_string(surface.Points.rows()) + " points");
    }
  }
  return BoundaryWalk(surface).Find();
}

void RequireSurfaceWithBoundary(const Surface& surface, LoopCount loops)
{
  const Topology topology = RequireManifold(surface, "the surface");
  if (topology.Components > 1)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.Components) +
      " components; keep one with Connectivity / Extract Largest");
  }
  if (topology.BoundaryLoops == 0)
  {
    throw InvalidInput("the surface is closed; cut it first with Shape Cut Feature");
  }
  if (topology.BoundaryLoops > 1 && loops == LoopCount::One)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.BoundaryLoops) +
      " open loops (first at point " + std::to_string(topology.FirstOpenPoint) +
      "); fill all but the outer one with Shape Fill Holes");
  }
  const int flat = 2 - topology.BoundaryLoops;
  if (topology.EulerNumber != flat)
  {
    throw InvalidInput("the surface has Euler number " + std::to_string(topology.EulerNumber) +
      " (genus " + std::to_string((flat - topology.EulerNumber) / 2) +
      "); a map to the plane needs" + " Euler number " + std::to_string(flat) +
      ": cut each handle with Clip and close the cuts with Shape Fill Holes");
  }
  const auto unused = (topology.ComponentId.array() < 0).count();
  if (unused > 0)
  {
    const auto first = std::find(topology.ComponentId.begin(), topology.ComponentId.end(), -1) -
      topology.ComponentId.begin();
    throw InvalidInput("the surface has " + std::to_string(unused) +
      (unused == 1 ? " point that no triangle uses" : " points that no triangle uses") +
      " (first at point " + std::to_string(first) + "); remove them with Clean");
  }
}

std::vector<std::vector<int>> FindManifoldBoundaryLoops(const Surface& surface)
{
  const std::vector<int>& twins = surface.Twins();
  const Eigen::MatrixXi& triangles = surface.Triangles();
  std::vector<int> next(surface.Points().rows(), -1);
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    if (twins[side] < 0)
    {
      next[triangles(side / 3, side % 3)] = triangles(side / 3, (side + 1) % 3);
    }
  }
  std::vector<std::vector<int>> loops;
  for (int first = 0; first < static_cast<int>(next.size()); ++first)
  {
    if (next[first] >= 0)
    {
      loops.emplace_back();
      for (int point = first; next[point] >= 0;)
      {
        loops.back().push_back(point);
        const int following = next[point];
        next[point] = -1;
        point = following;
      }
    }
  }
  std::stable_sort(loops.begin(), loops.end(),
    [&](const std::vector<int>& a, const std::vector<int>& b)
    { return ComputeLoopLength(a, surface.Points()) > ComputeLoopLength(b, surface.Points()); });
  return loops;
}

Mesh FillWithFans(const Mesh& surface, const std::vector<std::vector<int>>& loops)
{
  Eigen::Index sides = 0;
  for (const std::vector<int>& loop : loops)
  {
    sides += static_cast<Eigen::Index>(loop.size());
  }
  Mesh filled{ Eigen::MatrixXd(surface.Points.rows() + static_cast<Eigen::Index>(loops.size()), 3),
    Eigen::MatrixXi(surface.Triangles.rows() + sides, 3) };
  filled.Points.topRows(surface.Points.rows()) = surface.Points;
  filled.Triangles.topRows(surface.Triangles.rows()) = surface.Triangles;
  auto middle = static_cast<int>(surface.Points.rows());
  Eigen::Index row = surface.Triangles.rows();
  for (const std::vector<int>& loop : loops)
  {
    filled.Points.row(middle) = surface.Points(loop, Eigen::all).colwise().mean();
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      filled.Triangles.row(row++) << loop[(i + 1) % loop.size()], loop[i], middle;
    }
    ++middle;
  }
  return filled;
}

} // namespace shape
