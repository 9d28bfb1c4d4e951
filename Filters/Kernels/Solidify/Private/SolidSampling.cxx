#include "Solidify/Private/SolidSampling.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/HalfEdges.h"
#include "Solidify/Private/EdgeGroups.h"
#include "Solids/GridWinding.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <tuple>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// Where the surface crosses an edge of the grid.
struct SurfaceCrossing
{
  std::size_t Edge;
  double Position;
  int Triangle, Side;
};

/// The crossings with `edges`, edge by edge and in order along each.
std::vector<SurfaceCrossing> FindCrossings(const Mesh& surface, const SampledGrid& grid,
  const std::vector<GridEdge>& edges, const Progress& progress)
{
  std::vector<SurfaceCrossing> found;
  for (int axis = 0; axis < 3; ++axis)
  {
    ForEachGridCrossing(
      surface, grid, axis,
      [&](const GridCrossing& crossing)
      {
        const Eigen::RowVector3i& before = crossing.Before;
        if (before(axis) < 0)
        {
          return;
        }
        const GridEdge edge =
          3 * static_cast<GridEdge>(grid.Index(before(0), before(1), before(2))) + axis;
        const auto at = std::lower_bound(edges.begin(), edges.end(), edge);
        if (at != edges.end() && *at == edge)
        {
          found.push_back({ static_cast<std::size_t>(at - edges.begin()), crossing.Position,
            crossing.Triangle, crossing.Side });
        }
      },
      progress.Part(axis / 3.0, (axis + 1) / 3.0));
  }
  std::sort(found.begin(), found.end(),
    [](const SurfaceCrossing& a, const SurfaceCrossing& b) {
      return std::tie(a.Edge, a.Position, a.Triangle) < std::tie(b.Edge, b.Position, b.Triangle);
    });
  return found;
}

} // namespace

SampledGrid MakeGrid(const Mesh& mesh, double spacing, int margin)
{
  const Eigen::AlignedBox3d box = ComputeBox(mesh);
  const Eigen::Array3d cells = (box.sizes().array() / spacing).ceil() + 2.0 * margin + 2.0;
  if (!(cells.prod() <= MostGridPoints))
  {
    std::ostringstream words;
    words << "a grid with the spacing " << spacing << " around the surface would have "
          << cells.prod() << " points, more than " << MostGridPoints
          << "; raise DetailSize, or GapSize if it is set";
    throw InvalidInput(words.str());
  }
  SampledGrid grid;
  const RowVector3d shift(0.37, 0.29, 0.43);
  grid.Origin = box.min().transpose() - spacing * (shift.array() + margin).matrix();
  grid.Spacing = spacing;
  grid.Counts = cells.cast<int>().matrix().transpose();
  return grid;
}

Mesh CloseByCones(const Mesh& surface)
{
  const std::vector<HalfEdge> sorted = SortHalfEdges(surface.Triangles, surface.Points.rows());
  DisjointSets sets(static_cast<int>(surface.Points.rows()));
  std::vector<std::array<int, 2>> sides; // of the triangles that are missing
  ForEachEdge(sorted,
    [&](const HalfEdge* begin, const HalfEdge* end)
    {
      int sum = 0;
      for (const HalfEdge* edge = begin; edge != end; ++edge)
      {
        sum += edge->Begin < edge->End ? 1 : -1;
      }
      for (; sum != 0; sum += sum > 0 ? -1 : 1)
      {
        sets.Merge(begin->Low(), begin->High());
        sum > 0 ? sides.push_back({ begin->High(), begin->Low() })
                : sides.push_back({ begin->Low(), begin->High() });
      }
    });
  std::map<int, RowVector3d> sums;
  std::map<int, int> counts, apexes;
  for (const auto& side : sides)
  {
    const int set = sets.Find(side[0]);
    sums.emplace(set, RowVector3d::Zero()).first->second +=
      surface.Points.row(side[0]) + surface.Points.row(side[1]);
    counts[set] += 2;
  }
  Mesh closed = surface;
  const Eigen::Index points = surface.Points.rows(), triangles = surface.Triangles.rows();
  closed.Points.conservativeResize(points + static_cast<Eigen::Index>(sums.size()), 3);
  closed.Triangles.conservativeResize(triangles + static_cast<Eigen::Index>(sides.size()), 3);
  for (const auto& [set, sum] : sums)
  {
    const auto apex = static_cast<int>(points + static_cast<Eigen::Index>(apexes.size()));
    closed.Points.row(apex) = sum / counts[set];
    apexes[set] = apex;
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    closed.Triangles.row(triangles + static_cast<Eigen::Index>(i)) << sides[i][0], sides[i][1],
      apexes[sets.Find(sides[i][0])];
  }
  return closed;
}

Mesh ContourWinding(const Mesh& surface, double spacing, const Progress& progress)
{
  constexpr int margin = 1;
  GridSolid solid{ MakeGrid(surface, spacing, margin), {} };
  const Eigen::VectorXi winding =
    ComputeGridWindingNumbers(surface, solid.Grid, progress.Part(0.0, 0.3));
  solid.Inside.resize(winding.size());
  std::transform(winding.begin(), winding.end(), solid.Inside.begin(),
    [](int number) { return static_cast<char>(number >= 1); });
  const std::vector<GridEdge> edges = FindBoundaryEdges(solid);
  const std::vector<SurfaceCrossing> found =
    FindCrossings(surface, solid.Grid, edges, progress.Part(0.3, 0.7));
  std::vector<EdgeCrossing> crossings(edges.size());
  for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end)
  {
    const std::size_t edge = found[begin].Edge;
    const auto point = static_cast<int>(edges[edge] / 3);
    const int axis = static_cast<int>(edges[edge] % 3);
    int number = winding(point);
    std::vector<std::size_t> changes; // between inside and outside
    for (; end < found.size() && found[end].Edge == edge; ++end)
    {
      const int after = number - found[end].Side;
      if ((number >= 1) != (after >= 1))
      {
        changes.push_back(end);
      }
      number = after;
    }
    if (changes.empty()) // the lines along two axes are moved by different infinitesimal steps
    {
      continue;
    }
    const SurfaceCrossing& middle = found[changes[changes.size() / 2]];
    const Eigen::Matrix3d corners = GetCorners(surface, middle.Triangle);
    const bool leaves = solid.Inside[point] != 0;
    const RowVector3d normal =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).normalized();
    const int counts = solid.Grid.Counts(0), rows = solid.Grid.Counts(1);
    const std::array<int, 3> at = { point % counts, point / counts % rows, point / counts / rows };
    const double first = solid.Grid.Origin(axis) + spacing * at[axis];
    crossings[edge].Share = (middle.Position - first) / spacing;
    crossings[edge].Normal = leaves == (middle.Side > 0) ? normal : RowVector3d(-normal);
  }
  return ContourGrid(solid, edges, crossings, progress.Part(0.7, 1.0));
}

} // namespace shape
