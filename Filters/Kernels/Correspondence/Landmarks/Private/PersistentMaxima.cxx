#include "Correspondence/Landmarks/Private/PersistentMaxima.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace shape
{
namespace
{

std::vector<std::vector<int>> Neighbours(const Eigen::MatrixXi& triangles, Eigen::Index points)
{
  std::vector<std::vector<int>> neighbours(points);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int i = triangles(t, k), j = triangles(t, (k + 1) % 3);
      neighbours[i].push_back(j);
      neighbours[j].push_back(i);
    }
  }
  return neighbours;
}

} // namespace

std::vector<int> FindPersistentMaxima(
  const Eigen::MatrixXi& triangles, const Eigen::VectorXd& function, double minimum, int count)
{
  const auto n = static_cast<int>(function.size());
  std::vector<int> order(n), rank(n);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int i, int j) { return function(i) > function(j); });
  for (int k = 0; k < n; ++k)
  {
    rank[order[k]] = k;
  }
  const std::vector<std::vector<int>> neighbours = Neighbours(triangles, n);
  // As the level decreases, the part of the surface above it grows; each component stores its
  // highest point.
  DisjointSets parts(n);
  std::vector<int> highest(n);
  std::iota(highest.begin(), highest.end(), 0);
  std::vector<std::pair<double, int>> maxima; // persistence, point
  for (const int i : order)
  {
    for (const int j : neighbours[i])
    {
      const int own = parts.Find(i), other = parts.Find(j);
      // The neighbour is lower and not yet above the level, or already connected.
      if (rank[j] > rank[i] || own == other)
      {
        continue;
      }
      const auto [higher, lower] =
        std::minmax(highest[own], highest[other], [&](int p, int q) { return rank[p] < rank[q]; });
      // Point i is a saddle: the component with the lower maximum ends here, and its persistence is
      // known. If i itself is the lower one, it only extends a component.
      if (lower != i)
      {
        maxima.emplace_back(function(lower) - function(i), lower);
      }
      parts.Merge(own, other);
      highest[parts.Find(i)] = higher;
    }
  }
  if (n > 0)
  {
    // The highest maximum never merges into a higher one.
    maxima.emplace_back(function(order.front()) - function(order.back()), order.front());
  }
  std::sort(maxima.begin(), maxima.end(),
    [&](const auto& p, const auto& q)
    { return p.first != q.first ? p.first > q.first : rank[p.second] < rank[q.second]; });
  std::vector<int> found;
  for (const auto& [persistence, point] : maxima)
  {
    if (persistence >= minimum && static_cast<int>(found.size()) < count)
    {
      found.push_back(point);
    }
  }
  return found;
}

} // namespace shape
