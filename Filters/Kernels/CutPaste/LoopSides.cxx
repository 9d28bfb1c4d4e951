#include "CutPaste/LoopSides.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// The edges of loops, and the loop that contains each.
class LoopEdges
{
public:
  struct Edge
  {
    int Loop;
    bool IsForward; ///< whether it runs from the lower point to the higher one
  };

  LoopEdges(const std::vector<std::vector<int>>& loops, Eigen::Index points)
    : IsOnLoop(points, 0)
  {
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      for (std::size_t i = 0; i < loops[l].size(); ++i)
      {
        const int a = loops[l][i], b = loops[l][(i + 1) % loops[l].size()];
        this->IsOnLoop[a] = 1;
        const auto [edge, isNew] =
          this->Edges.insert({ std::minmax(a, b), { static_cast<int>(l), a < b } });
        if (!isNew)
        {
          this->Edges.erase(edge); // an edge of two loops separates nothing
        }
      }
    }
  }

  /// Returns nullptr for an edge that is on no loop.
  const Edge* Find(const HalfEdge& side) const
  {
    if (this->IsOnLoop[side.Begin] == 0 || this->IsOnLoop[side.End] == 0)
    {
      return nullptr;
    }
    const auto found = this->Edges.find({ side.Low(), side.High() });
    return found == this->Edges.end() ? nullptr : &found->second;
  }

private:
  std::vector<char> IsOnLoop;
  std::map<std::pair<int, int>, Edge> Edges;
};

/// Disjoint sets of the triangles and their opposites, two items for each triangle. Items on the
/// same side are in one set.
class Sides
{
public:
  // Disjoint sets with parity: "same side" merges a triangle with its neighbour, "different sides"
  // with its neighbour's opposite. A triangle in one set with its own opposite is a contradiction:
  // the loops do not divide the component.
  Sides(const std::vector<HalfEdge>& edges, const LoopEdges& loops)
    : Count(static_cast<int>(edges.size()) / 3)
    , Same(2 * this->Count)
    , Connected(this->Count)
  {
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
    {
      const HalfEdge &one = edges[i], &other = edges[i + 1];
      if (one.Low() != other.Low() || one.High() != other.High())
      {
        continue;
      }
      const int shift = loops.Find(one) ? this->Count : 0;
      this->Same.Merge(one.Triangle, other.Triangle + shift);
      this->Same.Merge(one.Triangle + this->Count, other.Triangle + this->Count - shift);
      this->Connected.Merge(one.Triangle, other.Triangle);
    }
  }

  bool AreSame(int a, int b) { return this->Same.Find(a) == this->Same.Find(b); }
  int Opposite(int triangle) const { return triangle + this->Count; }
  int Component(int triangle) { return this->Connected.Find(triangle); }

private:
  int Count;
  DisjointSets Same, Connected;
};

/// For each component with loops, a triangle to the left of its first loop, or the opposite of one
/// to the right.
std::map<int, int> LeftTriangles(
  const std::vector<HalfEdge>& edges, const LoopEdges& loops, Sides& sides)
{
  std::map<int, std::pair<int, int>> found; // the loop, and the triangle
  for (const HalfEdge& edge : edges)
  {
    if (const LoopEdges::Edge* loop = loops.Find(edge))
    {
      // A triangle is to the left of its own half-edges.
      const bool isLeft = (edge.Begin < edge.End) == loop->IsForward;
      const std::pair<int, int> own(
        loop->Loop, isLeft ? edge.Triangle : sides.Opposite(edge.Triangle));
      const auto [known, isNew] = found.insert({ sides.Component(edge.Triangle), own });
      // The first loop in the list is the longest, and decides left and right.
      if (!isNew && own.first < known->second.first)
      {
        known->second = own;
      }
    }
  }
  std::map<int, int> left;
  for (const auto& [component, own] : found)
  {
    left[component] = own.second;
  }
  return left;
}

} // namespace

std::vector<char> MarkTrianglesOnSide(
  const Surface& surface, const std::vector<std::vector<int>>& loops, LoopSide side)
{
  const auto count = static_cast<int>(surface.Triangles().rows());
  const LoopEdges loopEdges(loops, surface.Points().rows());
  const std::vector<HalfEdge>& edges = surface.HalfEdges();
  Sides sides(edges, loopEdges);
  const std::map<int, int> left = LeftTriangles(edges, loopEdges, sides);
  const Eigen::VectorXd areas = surface.AreaVectors().rowwise().norm();
  struct Area
  {
    double Left = 0.0, Right = 0.0;
    bool HasLeft = false, HasRight = false;
  };
  std::map<int, Area> areaOf;
  std::vector<char> isLeft(count, 0);
  for (int t = 0; t < count; ++t)
  {
    const auto own = left.find(sides.Component(t));
    if (own == left.end())
    {
      continue;
    }
    if (sides.AreSame(t, sides.Opposite(t)))
    {
      throw InvalidInput(std::string(loops.size() > 1 ? "the loops do" : "the loop does") +
        " not divide the surface: both sides are connected around a handle (at triangle " +
        std::to_string(t) + "); add a loop on the other side of the feature");
    }
    Area& area = areaOf[own->first];
    isLeft[t] = static_cast<char>(sides.AreSame(t, own->second));
    (isLeft[t] != 0 ? area.Left : area.Right) += areas(t);
    (isLeft[t] != 0 ? area.HasLeft : area.HasRight) = true;
  }
  std::vector<char> isOnSide(count, 0);
  bool hasBoth = false;
  for (int t = 0; t < count; ++t)
  {
    const auto own = areaOf.find(sides.Component(t));
    if (own != areaOf.end() && own->second.HasLeft && own->second.HasRight)
    {
      const Area& area = own->second;
      // Equal halves: the left one is the smaller, so exactly one side is taken.
      const bool takesLeft = side == LoopSide::Left ||
        (side == LoopSide::Smaller && area.Left <= area.Right) ||
        (side == LoopSide::Larger && area.Left > area.Right);
      isOnSide[t] = static_cast<char>((isLeft[t] != 0) == takesLeft);
      hasBoth = true;
    }
  }
  if (!hasBoth)
  {
    throw InvalidInput("the loop runs along the surface's boundary: there is nothing to cut; draw "
                       "it away from the boundary");
  }
  return isOnSide;
}

} // namespace shape
