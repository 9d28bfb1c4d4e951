#include "Solidify/Private/TriangleContacts.h"

#include "Geometry/Orientation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;
using Edge = std::array<int, 2>; // ascending

Edge EdgeOf(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

class ContactFinder
{
public:
  explicit ContactFinder(const Mesh& surface)
    : Surface(surface)
  {
    for (const auto& point : surface.Points.rowwise())
    {
      this->Found.Points.emplace_back(point);
    }
  }

  void AddPair(int first, int second)
  {
    const std::array<int, 3> a = this->SidesOf(first, second), b = this->SidesOf(second, first);
    if (a == std::array<int, 3>{})
    {
      this->AddCoplanar(first, second);
      this->AddCoplanar(second, first);
      return;
    }
    std::vector<int> contacts;
    for (int k = 0; k < 3; ++k)
    {
      this->MeetEdge(first, k, a[k], a[(k + 1) % 3], second, contacts);
      this->MeetEdge(second, k, b[k], b[(k + 1) % 3], first, contacts);
    }
    this->AddSegments(contacts, { first, second });
  }

  TriangleContacts Finish()
  {
    for (auto& [edge, points] : this->Found.OnEdge)
    {
      std::sort(points.begin(), points.end());
      points.erase(std::unique(points.begin(), points.end()), points.end());
    }
    return std::move(this->Found);
  }

private:
  int Corner(int triangle, int k) const { return this->Surface.Triangles(triangle, k % 3); }
  RowVector3d At(int point) const { return this->Surface.Points.row(point); }

  /// The sides of a plane on which the corners of a triangle lie.
  std::array<int, 3> SidesOf(int triangle, int plane) const
  {
    std::array<int, 3> sides;
    for (int k = 0; k < 3; ++k)
    {
      sides[k] =
        EvaluateOrientation(this->At(this->Corner(plane, 0)), this->At(this->Corner(plane, 1)),
          this->At(this->Corner(plane, 2)), this->At(this->Corner(triangle, k)));
    }
    return sides;
  }

  /// The axis along which triangles in the plane of this one are projected.
  int DroppedAxis(int triangle) const
  {
    const Eigen::Matrix3d corners = GetCorners(this->Surface, triangle);
    const RowVector3d normal =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0));
    std::array<int, 3> axes = { 0, 1, 2 };
    std::sort(axes.begin(), axes.end(),
      [&](int i, int j) { return std::abs(normal(i)) > std::abs(normal(j)); });
    for (const int axis : axes) // rounding may have chosen an axis in the plane
    {
      if (this->Turn(axis, this->Corner(triangle, 0), this->Corner(triangle, 1),
            this->Corner(triangle, 2)) != 0)
      {
        return axis;
      }
    }
    return axes[0];
  }

  int Turn(int axis, int a, int b, int c) const
  {
    const auto flat = [&](int point)
    {
      const RowVector3d position = this->At(point);
      return Eigen::RowVector2d(position((axis + 1) % 3), position((axis + 2) % 3));
    };
    return EvaluateOrientation(flat(a), flat(b), flat(c));
  }

  /// Where a point in the plane of a triangle lies: -1 outside, 3 inside, k on the edge from corner
  /// k, 4 + k at corner k.
  int Locate(int point, int triangle, int axis) const
  {
    std::array<int, 3> turns;
    for (int k = 0; k < 3; ++k)
    {
      if (this->Corner(triangle, k) == point)
      {
        return 4 + k;
      }
      turns[k] = this->Turn(axis, this->Corner(triangle, k), this->Corner(triangle, k + 1), point);
    }
    return LocationFrom(turns);
  }

  /// The same, from the sides of the three edges on which a position lies.
  static int LocationFrom(const std::array<int, 3>& turns)
  {
    const auto [low, high] = std::minmax_element(turns.begin(), turns.end());
    if (*low < 0 && *high > 0)
    {
      return -1;
    }
    for (int k = 0; k < 3; ++k)
    {
      if (turns[k] == 0 && turns[(k + 2) % 3] == 0)
      {
        return 4 + k;
      }
    }
    for (int k = 0; k < 3; ++k)
    {
      if (turns[k] == 0)
      {
        return k;
      }
    }
    return 3;
  }

  /// Notes that a point lies in a triangle, at a location as above.
  void AddTo(int triangle, int location, int point)
  {
    if (location == 3)
    {
      this->Found.Inside[triangle].push_back(point);
    }
    else if (location >= 0 && location < 3)
    {
      this->AddToEdge(
        EdgeOf(this->Corner(triangle, location), this->Corner(triangle, location + 1)), point);
    }
  }

  void AddToEdge(const Edge& edge, int point)
  {
    if (point != edge[0] && point != edge[1])
    {
      this->Found.OnEdge[edge].push_back(point);
    }
  }

  /// The contacts of the edge from corner k of a triangle with another one. begin, end: the sides
  /// of the other's plane on which its ends lie.
  void MeetEdge(int triangle, int k, int begin, int end, int other, std::vector<int>& contacts)
  {
    const int p = this->Corner(triangle, k), q = this->Corner(triangle, k + 1);
    if (begin == 0 && end == 0)
    {
      this->MeetCoplanarEdge(p, q, other, this->DroppedAxis(other), contacts);
      return;
    }
    if (begin == 0 || end == 0)
    {
      this->MeetPoint(begin == 0 ? p : q, other, this->DroppedAxis(other), contacts);
      return;
    }
    if (begin == end)
    {
      return;
    }
    std::array<int, 3> turns;
    for (int i = 0; i < 3; ++i)
    {
      turns[i] = EvaluateOrientation(this->At(p), this->At(q), this->At(this->Corner(other, i)),
        this->At(this->Corner(other, i + 1)));
    }
    const int location = LocationFrom(turns);
    if (location < 0)
    {
      return;
    }
    const Edge edge = EdgeOf(p, q);
    const int point = location >= 4 ? this->Corner(other, location - 4)
      : location < 3                ? this->EdgesMeet(edge,
                                        EdgeOf(this->Corner(other, location), this->Corner(other, location + 1)))
                                    : this->EdgeMeetsTriangle(edge, other);
    this->AddToEdge(edge, point);
    this->AddTo(other, location, point);
    contacts.push_back(point);
  }

  void MeetPoint(int point, int other, int axis, std::vector<int>& contacts)
  {
    if (const int location = this->Locate(point, other, axis); location >= 0)
    {
      this->AddTo(other, location, point);
      contacts.push_back(point);
    }
  }

  /// The contacts of an edge in the plane of a triangle.
  void MeetCoplanarEdge(int p, int q, int other, int axis, std::vector<int>& contacts)
  {
    const Edge edge = EdgeOf(p, q);
    this->MeetPoint(p, other, axis, contacts);
    this->MeetPoint(q, other, axis, contacts);
    for (int i = 0; i < 3; ++i)
    {
      const int a = this->Corner(other, i), b = this->Corner(other, i + 1);
      if (a != p && a != q && this->Turn(axis, p, q, a) == 0 && this->IsBetween(p, q, a))
      {
        this->AddToEdge(edge, a);
        contacts.push_back(a);
      }
      if (this->Turn(axis, p, q, a) * this->Turn(axis, p, q, b) < 0 &&
        this->Turn(axis, a, b, p) * this->Turn(axis, a, b, q) < 0)
      {
        const int point = this->EdgesMeet(edge, EdgeOf(a, b));
        this->AddToEdge(edge, point);
        this->AddToEdge(EdgeOf(a, b), point);
        contacts.push_back(point);
      }
    }
  }

  /// Whether a point on the line through p and q lies between them.
  bool IsBetween(int p, int q, int point) const
  {
    const RowVector3d a = this->At(p), b = this->At(q), c = this->At(point);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (a(axis) != b(axis))
      {
        return std::min(a(axis), b(axis)) < c(axis) && c(axis) < std::max(a(axis), b(axis));
      }
    }
    return false;
  }

  /// The edges of `first` become segments in `second`, which lies in the same plane.
  void AddCoplanar(int first, int second)
  {
    const int axis = this->DroppedAxis(second);
    for (int k = 0; k < 3; ++k)
    {
      std::vector<int> contacts;
      this->MeetCoplanarEdge(
        this->Corner(first, k), this->Corner(first, k + 1), second, axis, contacts);
      this->AddSegments(contacts, { second });
    }
  }

  /// Connects contacts on one line to segments of triangles.
  void AddSegments(std::vector<int>& contacts, const std::vector<int>& triangles)
  {
    std::sort(contacts.begin(), contacts.end());
    contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
    if (contacts.size() < 2)
    {
      return;
    }
    RowVector3d along = RowVector3d::Zero();
    for (const int contact : contacts)
    {
      const RowVector3d step = this->Found.Points[contact] - this->Found.Points[contacts[0]];
      along = step.squaredNorm() > along.squaredNorm() ? step : along;
    }
    std::stable_sort(contacts.begin(), contacts.end(),
      [&](int a, int b)
      { return along.dot(this->Found.Points[a]) < along.dot(this->Found.Points[b]); });
    for (const int triangle : triangles)
    {
      for (std::size_t i = 1; i < contacts.size(); ++i)
      {
        this->Found.Segments[triangle].push_back({ contacts[i - 1], contacts[i] });
      }
    }
  }

  int EdgeMeetsTriangle(const Edge& edge, int triangle)
  {
    return this->AddPoint({ edge[0], edge[1], triangle, -1 },
      [&]()
      {
        using Long = Eigen::Matrix<long double, 1, 3>;
        const Long a = this->At(this->Corner(triangle, 0)).cast<long double>();
        const Long u = this->At(this->Corner(triangle, 1)).cast<long double>() - a;
        const Long v = this->At(this->Corner(triangle, 2)).cast<long double>() - a;
        const Long normal = u.cross(v), p = this->At(edge[0]).cast<long double>(),
                   q = this->At(edge[1]).cast<long double>();
        const long double before = normal.dot(p - a), after = normal.dot(q - a);
        return Between(edge, before, before - after);
      });
  }

  int EdgesMeet(const Edge& first, const Edge& second)
  {
    const auto [one, other] = std::minmax(first, second);
    const Edge low = one, high = other;
    return this->AddPoint({ low[0], low[1], high[0], high[1] },
      [&]()
      {
        using Long = Eigen::Matrix<long double, 1, 3>;
        const Long p = this->At(low[0]).cast<long double>(),
                   a = this->At(high[0]).cast<long double>();
        const Long u = this->At(low[1]).cast<long double>() - p,
                   v = this->At(high[1]).cast<long double>() - a;
        const Long normal = u.cross(v);
        return Between(low, (a - p).cross(v).dot(normal), normal.squaredNorm());
      });
  }

  /// The position at the share part / whole of an edge.
  RowVector3d Between(const Edge& edge, long double part, long double whole) const
  {
    const long double share = whole == 0.0L ? 0.5L : std::clamp(part / whole, 0.0L, 1.0L);
    const auto p = this->At(edge[0]).cast<long double>().eval(),
               q = this->At(edge[1]).cast<long double>().eval();
    return (p + share * (q - p)).cast<double>();
  }

  template <typename Compute>
  int AddPoint(const std::array<int, 4>& key, const Compute& compute)
  {
    const auto [entry, isNew] =
      this->Indices.emplace(key, static_cast<int>(this->Found.Points.size()));
    if (isNew)
    {
      this->Found.Points.push_back(compute());
    }
    return entry->second;
  }

  const Mesh& Surface;
  std::map<std::array<int, 4>, int> Indices; ///< of edges and triangle, or of two edges
  TriangleContacts Found;
};

} // namespace

TriangleContacts FindTriangleContacts(
  const Mesh& surface, const std::vector<Crossing>& pairs, const Progress& progress)
{
  ContactFinder finder(surface);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    progress(static_cast<double>(i) / static_cast<double>(pairs.size()));
    finder.AddPair(pairs[i].First, pairs[i].Second);
  }
  return finder.Finish();
}

} // namespace shape
