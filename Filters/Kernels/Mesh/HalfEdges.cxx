#include "Mesh/HalfEdges.h"

#include <array>
#include <numeric>

namespace shape
{

std::vector<HalfEdge> SortHalfEdges(const Eigen::MatrixXi& triangles, Eigen::Index points)
{
  const auto side = [&](int triangle, int corner)
  {
    return HalfEdge{ triangles(triangle, corner), triangles(triangle, (corner + 1) % 3), triangle,
      corner };
  };
  const auto forAll = [&](const auto& visit)
  {
    for (int t = 0; t < triangles.rows(); ++t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        visit(side(t, corner));
      }
    }
  };
  // Few share their lower point, so a counting pass makes the sort fast.
  std::vector<int> start(points + 1, 0);
  forAll([&](const HalfEdge& edge) { ++start[edge.Low() + 1]; });
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<HalfEdge> sides(3 * triangles.rows());
  std::vector<int> next(start.begin(), start.end() - 1);
  forAll([&](const HalfEdge& edge) { sides[next[edge.Low()]++] = edge; });
  for (Eigen::Index low = 0; low < points; ++low)
  {
    std::sort(sides.begin() + start[low], sides.begin() + start[low + 1],
      [](const HalfEdge& a, const HalfEdge& b)
      {
        return std::array<int, 2>{ a.High(), a.Triangle } <
          std::array<int, 2>{ b.High(), b.Triangle };
      });
  }
  return sides;
}

std::vector<int> FindTwins(const Eigen::MatrixXi& triangles, Eigen::Index points)
{
  return FindTwins(SortHalfEdges(triangles, points));
}

std::vector<int> FindTwins(const std::vector<HalfEdge>& sorted)
{
  std::vector<int> twins(sorted.size(), -1);
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i)
  {
    const HalfEdge &one = sorted[i], &other = sorted[i + 1];
    if (one.Low() == other.Low() && one.High() == other.High())
    {
      const int side = 3 * one.Triangle + one.Corner, twin = 3 * other.Triangle + other.Corner;
      twins[side] = twin;
      twins[twin] = side;
    }
  }
  return twins;
}

} // namespace shape
