#include "Skeleton/Private/CurveSurgery.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Eigen::Vector3d;
using Triangle = std::array<int, 3>;

/// Closed surfaces whose points the links of a graph join.
class Surgery
{
public:
  explicit Surgery(const Mesh& surface)
    : Triangles(surface.Triangles.rows())
    , Fans(surface.Points.rows())
    , Into(surface.Points.rows())
    , Masses(surface.Points.rows(), 1.0)
    , LinkEnds(surface.Points.rows(), 0)
  {
    for (int i = 0; i < surface.Points.rows(); ++i)
    {
      this->Points.emplace_back(surface.Points.row(i).transpose());
      this->Into[i] = i;
    }
    for (int t = 0; t < surface.Triangles.rows(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Triangles[t][k] = surface.Triangles(t, k);
        this->Fans[surface.Triangles(t, k)].push_back(t);
      }
    }
  }

  CurveGraph Run(const Progress& progress)
  {
    for (int i = 0; i < static_cast<int>(this->Points.size()); ++i)
    {
      this->PushEdges(i, true);
    }
    const std::size_t first = this->Triangles.size();
    for (long long step = 0; !this->Queue.empty(); ++step)
    {
      const auto [length, a, b] = this->Queue.top();
      this->Queue.pop();
      if (this->Length(a, b) == length && this->HasEdge(a, b))
      {
        this->Remove(a, b);
      }
      if (step % 4096 == 0)
      {
        progress(1.0 - std::min(1.0, static_cast<double>(this->Left()) / first));
      }
    }
    progress(1.0);
    return this->Result();
  }

private:
  double Length(int a, int b) const { return (this->Points[a] - this->Points[b]).norm(); }

  /// Returns the point into which a point was merged.
  int Root(int point)
  {
    while (this->Into[point] != point)
    {
      point = this->Into[point] = this->Into[this->Into[point]];
    }
    return point;
  }

  std::size_t Left() const { return this->Triangles.size() - this->Removed; }

  bool HasEdge(int a, int b) const
  {
    return std::any_of(
      this->Fans[a].begin(), this->Fans[a].end(), [&](int t) { return this->CornerOf(t, b) >= 0; });
  }

  /// Returns the index of a point among the corners of a triangle, or -1.
  int CornerOf(int triangle, int point) const
  {
    const Triangle& corners = this->Triangles[triangle];
    return corners[0] == point ? 0 : corners[1] == point ? 1 : corners[2] == point ? 2 : -1;
  }

  /// The neighbour after (+1) or before (-1, as +2) a point in a triangle.
  int Beside(int triangle, int point, int way) const
  {
    return this->Triangles[triangle][(this->CornerOf(triangle, point) + way) % 3];
  }

  std::vector<int> Neighbours(int point) const
  {
    std::vector<int> found;
    for (const int t : this->Fans[point])
    {
      found.push_back(this->Beside(t, point, 1)); // each neighbour is next in one triangle
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  void PushEdges(int point, bool once)
  {
    for (const int other : this->Neighbours(point))
    {
      if (!once || point < other)
      {
        this->Queue.emplace(
          this->Length(point, other), std::min(point, other), std::max(point, other));
      }
    }
  }

  void Remove(int a, int b)
  {
    const std::vector<int> ofA = this->Neighbours(a), ofB = this->Neighbours(b);
    std::vector<int> common;
    std::set_intersection(
      ofA.begin(), ofA.end(), ofB.begin(), ofB.end(), std::back_inserter(common));
    if (common.size() == 2 && ofA.size() == 3 && ofB.size() == 3)
    {
      this->SpanTetrahedron({ a, b, common[0], common[1] });
    }
    else if (common.size() == 2)
    {
      this->Collapse(a, b);
    }
    else
    {
      this->Cut(a, b, this->NearestOpen(a, b, common));
    }
  }

  /// Returns the common neighbour with which an edge makes the shortest cycle that bounds no
  /// triangle.
  int NearestOpen(int a, int b, const std::vector<int>& common) const
  {
    int best = -1;
    double shortest = std::numeric_limits<double>::infinity();
    for (const int c : common)
    {
      const double length = this->Length(a, c) + this->Length(b, c);
      const bool face = std::any_of(this->Fans[a].begin(), this->Fans[a].end(),
        [&](int t) { return this->CornerOf(t, b) >= 0 && this->CornerOf(t, c) >= 0; });
      if (!face && length < shortest)
      {
        best = c;
        shortest = length;
      }
    }
    return best;
  }

  /// Whether a link of the graph joins two points: if they were merged, its cycle would be lost.
  bool AreLinked(int a, int b)
  {
    return std::any_of(this->Links.begin(), this->Links.end(),
      [&](const std::pair<int, int>& link)
      {
        const int c = this->Root(link.first), d = this->Root(link.second);
        return (c == a && d == b) || (c == b && d == a);
      });
  }

  void Collapse(int a, int b)
  {
    if (this->LinkEnds[a] > 0 && this->LinkEnds[b] > 0 && this->AreLinked(a, b))
    {
      return;
    }
    const double mass = this->Masses[a] + this->Masses[b];
    this->Points[b] =
      (this->Masses[a] * this->Points[a] + this->Masses[b] * this->Points[b]) / mass;
    this->Masses[b] = mass;
    this->LinkEnds[b] += this->LinkEnds[a];
    for (const int t : std::vector<int>(this->Fans[a]))
    {
      if (this->CornerOf(t, b) >= 0)
      {
        this->Erase(t);
      }
      else
      {
        this->Triangles[t][this->CornerOf(t, a)] = b;
        this->Fans[b].push_back(t);
      }
    }
    this->Fans[a].clear();
    this->Into[a] = b;
    this->PushEdges(b, false);
  }

  void Erase(int triangle)
  {
    for (const int corner : this->Triangles[triangle])
    {
      std::vector<int>& fan = this->Fans[corner];
      fan.erase(std::find(fan.begin(), fan.end(), triangle));
    }
    ++this->Removed;
  }

  void AddTriangle(const Triangle& corners)
  {
    for (const int corner : corners)
    {
      this->Fans[corner].push_back(static_cast<int>(this->Triangles.size()));
    }
    this->Triangles.push_back(corners);
  }

  void AddLink(int a, int b)
  {
    this->Links.emplace_back(a, b);
    ++this->LinkEnds[a];
    ++this->LinkEnds[b];
  }

  /// Returns the triangles around point b, left of the path from a over b to c.
  std::vector<int> LeftOf(int a, int b, int c) const
  {
    std::vector<int> left;
    for (int edge = c; edge != a;)
    {
      for (const int t : this->Fans[b])
      {
        if (this->Beside(t, b, 1) == edge)
        {
          left.push_back(t);
          edge = this->Beside(t, b, 2);
          break;
        }
      }
    }
    return left;
  }

  /// Cuts a surface along the cycle a, b, c: the left side gets new points.
  void Cut(int a, int b, int c)
  {
    const std::array<int, 3> old = { a, b, c };
    const std::array<std::vector<int>, 3> left = { this->LeftOf(c, a, b), this->LeftOf(a, b, c),
      this->LeftOf(b, c, a) };
    std::array<int, 3> copy{};
    for (int k = 0; k < 3; ++k)
    {
      copy[k] = static_cast<int>(this->Points.size());
      this->Points.push_back(Vector3d(this->Points[old[k]]));
      this->Masses[old[k]] *= 0.5;
      this->Masses.push_back(this->Masses[old[k]]);
      this->Fans.emplace_back();
      this->Into.push_back(copy[k]);
      this->LinkEnds.push_back(0);
    }
    for (int k = 0; k < 3; ++k)
    {
      for (const int t : left[k])
      {
        std::vector<int>& fan = this->Fans[old[k]];
        fan.erase(std::find(fan.begin(), fan.end(), t));
        this->Triangles[t][this->CornerOf(t, old[k])] = copy[k];
        this->Fans[copy[k]].push_back(t);
      }
    }
    this->AddTriangle(old);
    this->AddTriangle({ copy[0], copy[2], copy[1] });
    this->AddLink(a, copy[0]);
    for (int k = 0; k < 3; ++k)
    {
      this->PushEdges(old[k], false);
      this->PushEdges(copy[k], false);
    }
  }

  /// Replaces a surface of four points by the shortest tree over them (Prim's algorithm).
  void SpanTetrahedron(std::array<int, 4> points)
  {
    std::sort(points.begin(), points.end());
    for (const int t : std::vector<int>(this->Fans[points[0]]))
    {
      this->Erase(t);
    }
    this->Erase(this->Fans[points[1]].front());
    std::vector<int> tree = { points[0] };
    std::vector<int> rest(points.begin() + 1, points.end());
    while (!rest.empty())
    {
      std::tuple<double, int, int> best(std::numeric_limits<double>::infinity(), 0, 0);
      for (const int a : tree)
      {
        for (const int b : rest)
        {
          best = std::min(best, std::make_tuple(this->Length(a, b), a, b));
        }
      }
      const auto [length, a, b] = best;
      this->AddLink(a, b);
      tree.push_back(b);
      rest.erase(std::find(rest.begin(), rest.end(), b));
    }
  }

  CurveGraph Result()
  {
    CurveGraph graph;
    std::vector<int> number(this->Points.size(), -1);
    for (int i = 0; i < static_cast<int>(this->Points.size()); ++i)
    {
      if (this->Root(i) == i)
      {
        number[i] = graph.Size();
        graph.Positions.push_back(this->Points[i]);
        graph.Masses.push_back(this->Masses[i]);
      }
    }
    for (const auto& [a, b] : this->Links)
    {
      graph.Links.emplace_back(number[this->Root(a)], number[this->Root(b)]);
    }
    return graph;
  }

  using Entry = std::tuple<double, int, int>;
  std::vector<Vector3d> Points;
  std::vector<Triangle> Triangles;
  std::vector<std::vector<int>> Fans; ///< the triangles around each point
  std::vector<int> Into;
  std::vector<double> Masses;
  std::vector<int> LinkEnds;
  std::vector<std::pair<int, int>> Links;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Queue;
  std::size_t Removed = 0;
};

} // namespace

CurveGraph CollapseToCurves(const Mesh& surface, const Progress& progress)
{
  return Surgery(surface).Run(progress);
}

} // namespace shape
