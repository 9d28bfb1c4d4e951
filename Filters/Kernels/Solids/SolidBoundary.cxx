#include "Solids/SolidBoundary.h"

#include "Geometry/SelfIntersections.h"
#include "Mesh/Extent.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The data cached in a surface; it must not hold the surface itself.
struct KeptBoundary
{
  int Crossings = 0;
  Surface Bounding; ///< if there are crossings
};

/// A surface whose triangles face the other way.
struct KeptReverse
{
  Surface Reversed;
};

/// Triangles that are neighbours across an edge.
std::vector<std::vector<int>> Neighbours(const Surface& surface)
{
  std::vector<std::vector<int>> neighbours(surface.Triangles().rows());
  const std::vector<HalfEdge>& edges = surface.HalfEdges();
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
  {
    if (edges[i].Low() == edges[i + 1].Low() && edges[i].High() == edges[i + 1].High())
    {
      neighbours[edges[i].Triangle].push_back(edges[i + 1].Triangle);
      neighbours[edges[i + 1].Triangle].push_back(edges[i].Triangle);
    }
  }
  return neighbours;
}

// 1. The triangles that cross others are found; they are always kept.
// 2. The others form clusters connected across edges.
// 3. The winding number just outside one triangle of a cluster decides (Jacobson et al. 2013): the
//    cluster bounds the solid if it is 0.
KeptBoundary FindBoundary(const Surface& surface, const Progress& progress)
{
  const Mesh& mesh = surface;
  KeptBoundary result;
  const Eigen::Index count = mesh.Triangles.rows();
  // Degenerate triangles bound nothing, and their crossings are also found by others.
  std::vector<char> apart(count, 0);
  for (const int flat : FindDegenerateTriangles(mesh))
  {
    apart[flat] = 1;
  }
  std::vector<int> solid;
  for (int t = 0; t < count; ++t)
  {
    if (!apart[t])
    {
      solid.push_back(t);
    }
  }
  const Surface tested = static_cast<Eigen::Index>(solid.size()) == count
    ? surface
    : Surface(mesh.Points, mesh.Triangles(solid, Eigen::all));
  const std::vector<Crossing> crossings = FindSelfIntersections(tested, progress.Part(0.0, 0.5));
  result.Crossings = static_cast<int>(crossings.size());
  if (crossings.empty())
  {
    return result;
  }
  for (const Crossing& crossing : crossings)
  {
    apart[solid[crossing.First]] = apart[solid[crossing.Second]] = 1;
  }
  // Triangles connected without crossings are all inside or all outside.
  const std::vector<std::vector<int>> neighbours = Neighbours(surface);
  const double step = 1e-6 * ComputeLongestBoxEdge(mesh);
  std::vector<int> kept;
  std::vector<char> seen = apart;
  for (int first = 0; first < count; ++first)
  {
    progress(0.5 + 0.5 * first / static_cast<double>(count));
    if (apart[first])
    {
      kept.push_back(first);
    }
    if (seen[first])
    {
      continue;
    }
    std::vector<int> cluster = { first };
    seen[first] = 1;
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
      for (const int next : neighbours[cluster[i]])
      {
        if (!seen[next])
        {
          seen[next] = 1;
          cluster.push_back(next);
        }
      }
    }
    const Eigen::Matrix3d corners = GetCorners(mesh, first);
    const Eigen::RowVector3d normal =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).normalized();
    const double outside =
      ComputeWindingNumber(mesh.Points, mesh.Triangles, corners.colwise().mean() + step * normal);
    if (outside > -0.5 && outside < 0.5)
    {
      kept.insert(kept.end(), cluster.begin(), cluster.end());
    }
  }
  result.Bounding = Surface(mesh.Points, mesh.Triangles(kept, Eigen::all));
  return result;
}

} // namespace

SolidBoundaryResult ExtractSolidBoundary(const Surface& surface, const Progress& progress)
{
  const auto kept = surface.Cached<KeptBoundary>([&]() { return FindBoundary(surface, progress); });
  return { kept->Crossings > 0 ? kept->Bounding : surface, kept->Crossings };
}

Surface OrientOutwards(const Surface& surface)
{
  if (ComputeEnclosedVolume(surface) >= 0.0)
  {
    return surface;
  }
  return surface
    .Cached<KeptReverse>([&]() { return KeptReverse{ OrientOutwards(surface.AsMesh()) }; })
    ->Reversed;
}

} // namespace shape
