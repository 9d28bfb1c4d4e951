#include "Mesh/TouchingSheets.h"

#include "Base/DisjointSets.h"

#include <map>
#include <numeric>
#include <utility>

namespace shape
{

std::vector<int> FindFans(const Mesh& mesh, const std::vector<HalfEdge>& sorted)
{
  DisjointSets fans(static_cast<int>(3 * mesh.Triangles.rows()));
  const auto cornerOf = [&](int triangle, int point)
  {
    const auto row = mesh.Triangles.row(triangle);
    return 3 * triangle + (row(0) == point ? 0 : row(1) == point ? 1 : 2);
  };
  // The corners at both ends of a shared edge.
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i)
  {
    const HalfEdge& a = sorted[i];
    const HalfEdge& b = sorted[i + 1];
    if (a.Low() == b.Low() && a.High() == b.High())
    {
      fans.Merge(cornerOf(a.Triangle, a.Low()), cornerOf(b.Triangle, a.Low()));
      fans.Merge(cornerOf(a.Triangle, a.High()), cornerOf(b.Triangle, a.High()));
    }
  }
  std::vector<int> fanOf(3 * mesh.Triangles.rows());
  for (int corner = 0; corner < static_cast<int>(fanOf.size()); ++corner)
  {
    fanOf[corner] = fans.Find(corner);
  }
  return fanOf;
}

SplitSheets SplitTouchingSheets(const Mesh& mesh)
{
  const std::vector<int> fanOf = FindFans(mesh, SortHalfEdges(mesh.Triangles, mesh.Points.rows()));
  SplitSheets split{ mesh, std::vector<int>(mesh.Points.rows()) };
  std::iota(split.Copied.begin(), split.Copied.end(), 0);
  std::vector<int> firstFan(mesh.Points.rows(), -1);
  std::map<int, int> copyOf; // from further fans to their points
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int point = mesh.Triangles(t, k);
      const int fan = fanOf[3 * t + k];
      if (firstFan[point] == -1)
      {
        firstFan[point] = fan;
      }
      if (firstFan[point] != fan)
      {
        const auto [copy, isNew] = copyOf.insert({ fan, static_cast<int>(split.Copied.size()) });
        if (isNew)
        {
          split.Copied.push_back(point);
        }
        split.Surface.Triangles(t, k) = copy->second;
      }
    }
  }
  split.Surface.Points = mesh.Points(split.Copied, Eigen::all);
  return split;
}

} // namespace shape
