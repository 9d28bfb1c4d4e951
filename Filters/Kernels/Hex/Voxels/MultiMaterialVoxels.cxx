#include "Hex/Voxels/MultiMaterialVoxels.h"

#include "Hex/Voxels/WellComposedVoxels.h"
#include "Solids/Nesting.h"
#include "Solids/SolidRegions.h"
#include "Solids/SurfaceComplex.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// Throws if surfaces are not closed, cross each other, or are not nested inside the outer one.
void RequireNested(
  const Surface& surface, const std::vector<Surface>& innerSurfaces, const Progress& progress)
{
  std::vector<Surface> surfaces = { surface };
  std::vector<std::string> names = { "the Surface" };
  for (std::size_t i = 0; i < innerSurfaces.size(); ++i)
  {
    surfaces.push_back(innerSurfaces[i]);
    names.push_back("inner surface " + std::to_string(i));
  }
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    RequireClosed(surfaces[s], names[s]);
  }
  RequireConformingComplex(JoinSurfaces(surfaces), names, 1.0, progress.Part(0.0, 0.8));
  const SolidRegions regions(surfaces, names, progress.Part(0.8, 1.0)); // throws if not inside
}

/// Marks the corners of cells around which some of the eight cells are inside and some are not.
std::vector<char> BoundaryCorners(const SampledGrid& grid, const std::vector<char>& inside)
{
  std::vector<char> marked(inside.size(), 0); // the corner towards the origin of each cell
  for (int z = 1; z < grid.Counts(2); ++z)
  {
    for (int y = 1; y < grid.Counts(1); ++y)
    {
      for (int x = 1; x < grid.Counts(0); ++x)
      {
        int count = 0;
        for (int k = 0; k < 8; ++k)
        {
          count += inside[grid.Index(x - (k & 1), y - (k >> 1 & 1), z - (k >> 2))];
        }
        marked[grid.Index(x, y, z)] = count > 0 && count < 8;
      }
    }
  }
  return marked;
}

/// Returns, for each cell that is inside, the size of its part; parts are connected by faces.
std::vector<int> PartSizes(const SampledGrid& grid, const std::vector<char>& inside)
{
  const int strides[] = { 1, grid.Counts(0), grid.Counts(0) * grid.Counts(1) };
  std::vector<int> sizes(inside.size(), 0);
  for (int first = 0; first < static_cast<int>(inside.size()); ++first)
  {
    if (!inside[first] || sizes[first] > 0)
    {
      continue;
    }
    std::vector<int> cells = { first };
    sizes[first] = 1;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      for (const int stride : strides)
      {
        for (const int next : { cells[i] - stride, cells[i] + stride })
        {
          if (inside[next] && sizes[next] == 0)
          {
            sizes[next] = 1;
            cells.push_back(next);
          }
        }
      }
    }
    for (const int cell : cells)
    {
      sizes[cell] = static_cast<int>(cells.size());
    }
  }
  return sizes;
}

} // namespace

MultiMaterialVoxels::MultiMaterialVoxels(
  const Surface& surface, const std::vector<Surface>& innerSurfaces, const Progress& progress)
  : Whole(surface, progress.Part(0.0, 0.3))
{
  if (innerSurfaces.empty())
  {
    return;
  }
  RequireNested(surface, innerSurfaces, progress.Part(0.3, 0.9));
  for (std::size_t i = 0; i < innerSurfaces.size(); ++i)
  {
    this->Parts.emplace_back(
      OrientByNesting(innerSurfaces[i], "inner surface " + std::to_string(i)));
  }
}

std::vector<Surface> MultiMaterialVoxels::InnerSurfaces() const
{
  std::vector<Surface> surfaces;
  std::transform(this->Parts.begin(), this->Parts.end(), std::back_inserter(surfaces),
    [](const TopologyPreservingVoxels& part) { return part.GetSurface(); });
  return surfaces;
}

std::optional<RegionCells> MultiMaterialVoxels::Fill(
  double size, const GridDensity& warp, const Progress& progress, VoxelRule rule)
{
  const SampledGrid grid = this->Whole.Grid(size, warp);
  std::vector<std::vector<char>> insides;
  // The corners of cells on boundaries that were accepted before. A boundary that shares one is
  // refused, so the boundary of each region is a manifold.
  std::vector<char> taken(grid.Counts.prod(), 0);
  const auto accepts = [&](const std::vector<char>& inside)
  {
    std::vector<char> corners = BoundaryCorners(grid, inside);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      if (corners[i] && taken[i])
      {
        return false;
      }
    }
    std::transform(corners.begin(), corners.end(), taken.begin(), taken.begin(),
      [](char one, char other) { return static_cast<char>(one | other); });
    return true;
  };
  const double surfaces = 1.0 + static_cast<double>(this->Parts.size());
  // The whole solid first, then each inner surface: all on the same grid.
  for (std::size_t s = 0; s <= this->Parts.size(); ++s)
  {
    TopologyPreservingVoxels& solid = s == 0 ? this->Whole : this->Parts[s - 1];
    std::optional<std::vector<char>> inside = solid.CellsInside(grid, warp, accepts,
      progress.Part(static_cast<double>(s) / surfaces, (static_cast<double>(s) + 1.0) / surfaces),
      rule);
    if (!inside)
    {
      return std::nullopt;
    }
    insides.push_back(std::move(*inside));
  }
  RegionCells cells;
  cells.Solid = BuildVoxelHexahedra(grid, insides[0]);
  const Eigen::Index count = cells.Solid.Hexahedra.rows();
  cells.RegionOf = Eigen::VectorXi::Zero(count);
  Eigen::VectorXi minimum =
    Eigen::VectorXi::Constant(count, std::numeric_limits<int>::max()); // of the parts around
  for (std::size_t i = 1; i < insides.size(); ++i)
  {
    const std::vector<int> sizes = PartSizes(grid, insides[i]);
    std::vector<char> inside(count, 0);
    std::vector<int> rows;
    int hex = 0;
    for (std::size_t cell = 0; cell < sizes.size(); ++cell)
    {
      if (insides[0][cell])
      {
        if (insides[i][cell])
        {
          inside[hex] = 1;
          rows.push_back(hex);
          // The innermost surface around the cell is the one with the smallest part.
          if (sizes[cell] < minimum(hex))
          {
            minimum(hex) = sizes[cell];
            cells.RegionOf(hex) = static_cast<int>(i);
          }
        }
        ++hex;
      }
    }
    cells.Interfaces.push_back(
      FindBoundaryQuads({ cells.Solid.Points, cells.Solid.Hexahedra(rows, Eigen::all) }));
    cells.Inside.push_back(std::move(inside));
  }
  cells.Solid.Points = warp.Backward(cells.Solid.Points);
  return cells;
}

} // namespace shape
