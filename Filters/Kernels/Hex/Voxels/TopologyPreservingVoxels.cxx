#include "Hex/Voxels/TopologyPreservingVoxels.h"

#include "Hex/Voxels/Private/NarrowBandDistance.h"
#include "Hex/Voxels/WellComposedVoxels.h"
#include "Mesh/QuadSurface.h"
#include "Remesh/LongestEdgeBisection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace shape
{
namespace
{

/// How far outside, in cells, the centre of a cell may lie that counts as inside: with a little,
/// thin parts stay whole.
constexpr double Reaches[] = { 0.15, 0.0, 0.3, -0.15 };
/// How far, in cells, the surface may lie from the cells on either side of it.
constexpr double CoverReach = 0.7;

/// How many components of a surface bound solids from outside.
int CountSolids(const Mesh& surface)
{
  const std::vector<Mesh> components = SplitComponents(surface);
  return static_cast<int>(std::count_if(components.begin(), components.end(),
    [](const Mesh& component) { return ComputeEnclosedVolume(component) > 0.0; }));
}

/// A surface in warped space, its edges so short that they may as well be straight there; itself
/// if the warp is the identity.
Surface Warp(const Surface& surface, const GridDensity& warp, double size)
{
  if (warp.IsIdentity())
  {
    return surface;
  }
  Mesh fine = surface;
  constexpr double longest = 3.0; // cells
  for (bool more = true; more;)
  {
    std::vector<char> marked(fine.Triangles.rows(), 0);
    for (Eigen::Index t = 0; t < fine.Triangles.rows(); ++t)
    {
      const Eigen::Matrix3d corners = GetCorners(fine, t);
      for (int k = 0; k < 3; ++k)
      {
        marked[t] |= (corners.row(k) - corners.row((k + 1) % 3)).norm() > longest * size;
      }
    }
    more = std::find(marked.begin(), marked.end(), 1) != marked.end();
    if (more)
    {
      BisectLongestEdges(fine, marked);
    }
  }
  fine.Points = warp.Forward(fine.Points);
  return fine;
}

} // namespace

TopologyPreservingVoxels::TopologyPreservingVoxels(const Surface& surface, const Progress& progress)
  : Whole(OrientOutwards(surface))
  , Wanted(RequireClosedSurface(this->Whole, "the surface"))
  , Solids(CountSolids(this->Whole))
  , Bounding(ExtractSolidBoundary(this->Whole, progress))
{
}

double TopologyPreservingVoxels::CellSizeFor(double hexahedra, const GridDensity& warp) const
{
  const Mesh warped{ warp.Forward(this->Whole.Points()), this->Whole.Triangles() };
  const double volume = ComputeEnclosedVolume(warped), area = ComputeArea(warped);
  // The layer has more hexahedra than the cells whose room it takes: half a cell's volume for each
  // cell's area was measured.
  double size = std::cbrt(volume / hexahedra);
  for (int step = 0; step < 50; ++step)
  {
    size = std::cbrt((volume + 0.5 * area * size) / hexahedra);
  }
  return size;
}

SampledGrid TopologyPreservingVoxels::Grid(double size, const GridDensity& warp) const
{
  return BuildGridAround(Warp(this->Whole, warp, size).Points(), size);
}

std::optional<std::vector<char>> TopologyPreservingVoxels::CellsInside(const SampledGrid& grid,
  const GridDensity& warp, const std::function<bool(const std::vector<char>& inside)>& accepts,
  const Progress& progress)
{
  const double size = grid.Spacing;
  const Surface whole = Warp(this->Whole, warp, size);
  const Surface bounding =
    this->Bounding.Crossings == 0 ? whole : Warp(this->Bounding.Surface, warp, size);
  SampledGrid levels = grid;
  SampleDistances(whole, SurfaceLocator(bounding), levels, progress.Part(0.0, 0.6));
  const Eigen::VectorXd distances = levels.Values;
  constexpr double positionsPerCell = 30.0;
  constexpr unsigned int seed = 1;
  const Eigen::MatrixXd positions = SampleRandomly(
    bounding, static_cast<int>(positionsPerCell * ComputeArea(bounding) / (size * size)), seed);
  for (const double& reach : Reaches)
  {
    const double tried = static_cast<double>(&reach - Reaches) / std::size(Reaches);
    const Progress part = progress.Part(0.6 + 0.4 * tried, 1.0);
    part(0.0);
    levels.Values = distances.array() - reach * size;
    WellComposedVoxels solid = FindVoxelSolid(levels);
    if (solid.Pinched > 0)
    {
      continue;
    }
    KeepLargestParts(levels, this->Solids, solid.Inside);
    part(0.1);
    CoverSurface(levels, positions, CoverReach, solid.Inside);
    part(0.15);
    const HexMesh cubes = BuildVoxelHexahedra(levels, solid.Inside);
    if (cubes.Hexahedra.rows() > 0 && this->HasTopology(cubes) && accepts(solid.Inside))
    {
      return std::move(solid.Inside);
    }
  }
  return std::nullopt;
}

std::optional<HexMesh> TopologyPreservingVoxels::Fill(
  double size, const GridDensity& warp, const Progress& progress)
{
  const SampledGrid grid = this->Grid(size, warp);
  const std::optional<std::vector<char>> inside = this->CellsInside(
    grid, warp, [](const std::vector<char>&) { return true; }, progress);
  if (!inside)
  {
    return std::nullopt;
  }
  HexMesh cubes = BuildVoxelHexahedra(grid, *inside);
  cubes.Points = warp.Backward(cubes.Points);
  return cubes;
}

bool TopologyPreservingVoxels::HasTopology(const HexMesh& cubes)
{
  if (this->Bounding.Crossings == 0)
  {
    return HasBoundaryTopology(cubes, this->Wanted);
  }
  const Topology found = ComputeBoundaryTopology(cubes);
  const std::pair<int, int> now(found.EulerNumber, found.Components);
  const bool again = this->Before == now;
  this->Before = now;
  return again || this->TakesAny;
}

} // namespace shape
