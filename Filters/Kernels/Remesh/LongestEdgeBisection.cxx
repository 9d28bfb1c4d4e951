#include "Remesh/LongestEdgeBisection.h"

#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <array>
#include <utility>

namespace shape
{

namespace
{

/// The edges of a surface, without repeats.
struct Edges
{
  std::vector<std::pair<int, int>> Ends; ///< the lower point first
  Eigen::MatrixXi OfTriangle;            ///< m x 3: column k is the edge from corner k to the next
};

Edges EdgesOf(const Mesh& surface)
{
  Edges edges;
  edges.OfTriangle.resize(surface.Triangles.rows(), 3);
  for (const HalfEdge& side : SortHalfEdges(surface.Triangles, surface.Points.rows()))
  {
    const std::pair<int, int> ends(side.Low(), side.High());
    if (edges.Ends.empty() || edges.Ends.back() != ends)
    {
      edges.Ends.push_back(ends);
    }
    edges.OfTriangle(side.Triangle, side.Corner) = static_cast<int>(edges.Ends.size()) - 1;
  }
  return edges;
}

/// Returns the corner of each triangle at which its longest edge begins. Ties are decided by the
/// edge index, so that both triangles of an edge agree.
std::vector<int> LongestCorners(const Mesh& surface, const Edges& edges)
{
  std::vector<double> lengths;
  for (const auto& [a, b] : edges.Ends)
  {
    lengths.push_back((surface.Points.row(a) - surface.Points.row(b)).squaredNorm());
  }
  std::vector<int> corners(surface.Triangles.rows());
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    const auto rank = [&](int k)
    {
      const int edge = edges.OfTriangle(t, k);
      return std::pair<double, int>(-lengths[edge], edge);
    };
    const std::array<int, 3> candidates{ 0, 1, 2 };
    corners[t] = *std::min_element(
      candidates.begin(), candidates.end(), [&](int a, int b) { return rank(a) < rank(b); });
  }
  return corners;
}

/// A triangle with any bisected edge has its longest edge bisected, too. This is
/// the propagation of Rivara 1984; each edge is marked once, so it ends.
void Close(std::vector<char>& halved, const Edges& edges, const std::vector<int>& longest)
{
  std::vector<std::array<int, 2>> sides(edges.Ends.size(), { -1, -1 });
  for (int t = 0; t < edges.OfTriangle.rows(); ++t)
  {
    for (const int edge : edges.OfTriangle.row(t))
    {
      sides[edge][sides[edge][0] < 0 ? 0 : 1] = t;
    }
  }
  std::vector<int> fresh;
  for (int edge = 0; edge < static_cast<int>(halved.size()); ++edge)
  {
    if (halved[edge])
    {
      fresh.push_back(edge);
    }
  }
  while (!fresh.empty())
  {
    const int edge = fresh.back();
    fresh.pop_back();
    for (const int t : sides[edge])
    {
      const int next = t < 0 ? edge : edges.OfTriangle(t, longest[t]);
      if (!halved[next])
      {
        halved[next] = 1;
        fresh.push_back(next);
      }
    }
  }
}

} // namespace

// 1. The edges of marked triangles are to be bisected.
// 2. Close: so is the longest edge of every triangle with such an edge.
// 3. Each triangle is split at its longest edge first, then its halves at the other edges.
Eigen::MatrixXi BisectLongestEdges(Mesh& surface, const std::vector<char>& marked)
{
  const Edges edges = EdgesOf(surface);
  const std::vector<int> longest = LongestCorners(surface, edges);
  std::vector<char> halved(edges.Ends.size(), 0);
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    for (const int edge : edges.OfTriangle.row(t))
    {
      halved[edge] = halved[edge] || marked[t];
    }
  }
  Close(halved, edges, longest);

  const int before = static_cast<int>(surface.Points.rows());
  std::vector<int> middle(edges.Ends.size(), -1);
  std::vector<std::pair<int, int>> parents;
  for (std::size_t edge = 0; edge < halved.size(); ++edge)
  {
    if (halved[edge])
    {
      middle[edge] = before + static_cast<int>(parents.size());
      parents.push_back(edges.Ends[edge]);
    }
  }
  Eigen::MatrixXi ends(parents.size(), 2);
  surface.Points.conservativeResize(before + ends.rows(), 3);
  for (Eigen::Index k = 0; k < ends.rows(); ++k)
  {
    ends.row(k) << parents[k].first, parents[k].second;
    surface.Points.row(before + k) =
      0.5 * (surface.Points.row(parents[k].first) + surface.Points.row(parents[k].second));
  }

  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(surface.Triangles.rows() + 2 * ends.rows());
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    const int k = longest[t];
    // a-b is the longest edge, c lies opposite.
    const int a = surface.Triangles(t, k), b = surface.Triangles(t, (k + 1) % 3),
              c = surface.Triangles(t, (k + 2) % 3);
    const int ab = middle[edges.OfTriangle(t, k)], bc = middle[edges.OfTriangle(t, (k + 1) % 3)],
              ca = middle[edges.OfTriangle(t, (k + 2) % 3)];
    if (ab < 0)
    {
      triangles.push_back({ a, b, c });
      continue;
    }
    if (ca < 0)
    {
      triangles.push_back({ a, ab, c });
    }
    else
    {
      triangles.push_back({ a, ab, ca });
      triangles.push_back({ ca, ab, c });
    }
    if (bc < 0)
    {
      triangles.push_back({ ab, b, c });
    }
    else
    {
      triangles.push_back({ ab, b, bc });
      triangles.push_back({ ab, bc, c });
    }
  }
  surface.Triangles.resize(triangles.size(), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    surface.Triangles.row(t) << triangles[t][0], triangles[t][1], triangles[t][2];
  }
  return ends;
}

} // namespace shape
