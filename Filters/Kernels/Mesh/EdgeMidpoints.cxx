#include "Mesh/EdgeMidpoints.h"

#include <algorithm>
#include <map>
#include <set>

namespace shape
{

CutTriangles SplitEdges(
  const Eigen::MatrixXi& triangles, const std::vector<std::array<int, 2>>& edges, int points)
{
  CutTriangles cut{ {}, {}, edges };
  std::map<std::array<int, 2>, int> midpoints;
  for (const std::array<int, 2>& edge : edges)
  {
    midpoints.emplace(edge, points++);
  }
  std::vector<Eigen::RowVector3i> parts;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    // Split at one of its edges; the parts are then split at the others.
    std::size_t part = parts.size();
    parts.emplace_back(triangles.row(t));
    for (; part < parts.size(); ++part)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = parts[part](k), b = parts[part]((k + 1) % 3), c = parts[part]((k + 2) % 3);
        const auto middle = midpoints.find({ std::min(a, b), std::max(a, b) });
        if (middle != midpoints.end())
        {
          parts[part] << a, middle->second, c;
          parts.emplace_back(middle->second, b, c);
          k = -1;
        }
      }
    }
    cut.Original.resize(parts.size(), static_cast<int>(t));
  }
  cut.Triangles.resize(static_cast<Eigen::Index>(parts.size()), 3);
  for (std::size_t t = 0; t < parts.size(); ++t)
  {
    cut.Triangles.row(static_cast<Eigen::Index>(t)) = parts[t];
  }
  return cut;
}

std::vector<std::array<int, 2>> FindLoopChords(
  const Eigen::MatrixXi& triangles, const std::vector<int>& loop)
{
  std::map<int, std::size_t> at; // in the loop
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    at.emplace(loop[i], i);
  }
  std::set<std::array<int, 2>> chords;
  for (const auto triangle : triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto a = at.find(triangle(k)), b = at.find(triangle((k + 1) % 3));
      if (a != at.end() && b != at.end() && (a->second + 1) % loop.size() != b->second &&
        (b->second + 1) % loop.size() != a->second)
      {
        chords.insert({ std::min(a->first, b->first), std::max(a->first, b->first) });
      }
    }
  }
  return { chords.begin(), chords.end() };
}

} // namespace shape
