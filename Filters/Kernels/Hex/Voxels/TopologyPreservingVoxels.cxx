#include "Hex/Voxels/TopologyPreservingVoxels.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Hex/Voxels/WellComposedVoxels.h"
#include "Mesh/QuadSurface.h"
#include "Remesh/LongestEdgeBisection.h"
#include "Solids/GridWinding.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

/// Marks the cells whose centres may be nearer than LevelBand cells to a surface.
std::vector<char> CellsNear(const Mesh& surface, const SampledGrid& grid)
{
  std::vector<char> near(grid.Counts.cast<Eigen::Index>().prod(), 0);
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = (GetCorners(surface, t).rowwise() - grid.Origin) / grid.Spacing;
    const Eigen::Array3i low =
      (corners.colwise().minCoeff().transpose().array() - LevelBand).ceil().cast<int>().max(0);
    const Eigen::Array3i high = (corners.colwise().maxCoeff().transpose().array() + LevelBand)
                                  .floor()
                                  .cast<int>()
                                  .min(grid.Counts.transpose().array() - 1);
    // Cells of the box that are farther from the plane of a large triangle are left out.
    const Eigen::RowVector3d edge = corners.row(1) - corners.row(0),
                             other = corners.row(2) - corners.row(0);
    const Eigen::RowVector3d normal = edge.cross(other).normalized();
    const double band = LevelBand * (1.0 + 1e-9);
    for (int z = low(2); z <= high(2); ++z)
    {
      for (int y = low(1); y <= high(1); ++y)
      {
        const auto row = near.begin() + grid.Index(0, y, z);
        double height = (Eigen::RowVector3d(low(0), y, z) - corners.row(0)).dot(normal);
        for (int x = low(0); x <= high(0); ++x, height += normal(0))
        {
          row[x] |= static_cast<char>(std::abs(height) <= band);
        }
      }
    }
  }
  return near;
}

} // namespace

SampledGrid BuildGridAround(const Eigen::MatrixXd& points, double size)
{
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const Eigen::RowVector3d high = points.colwise().maxCoeff();
  const Eigen::RowVector3d counts = ((high - low) / size).array().ceil() + 3.0;
  // The samples of this number of cells take 1.6 GB.
  constexpr double maximum = 2e8;
  if (!(counts.prod() <= maximum))
  {
    throw InvalidInput("cells of size " + FormatNumber(size) + " give a grid of " +
      std::to_string(counts.prod()) + " cells around the surface; at most " +
      std::to_string(maximum) +
      " are possible; set a larger CellSize, or align the surface with the axes");
  }
  SampledGrid grid;
  grid.Spacing = size;
  grid.Counts = counts.cast<int>();
  grid.Origin = 0.5 * (low + high) - 0.5 * size * (counts.array() - 1.0).matrix();
  return grid;
}

void SampleDistances(
  const Mesh& surface, const SurfaceLocator& boundary, SampledGrid& grid, const Progress& progress)
{
  // The signs come from winding numbers, which are right for surfaces that cross themselves, too.
  // Distances are only computed in the band.
  const double far = LevelBand * grid.Spacing;
  const Eigen::VectorXi windings = ComputeGridWindingNumbers(surface, grid);
  progress(0.0);
  grid.Values =
    (windings.array() > 0).select(Eigen::VectorXd::Constant(windings.size(), -far), far);
  const std::vector<char> near = CellsNear(boundary.GetSurface(), grid);
  std::vector<int> cells;
  for (int cell = 0; cell < static_cast<int>(near.size()); ++cell)
  {
    if (near[cell])
    {
      cells.push_back(cell);
    }
  }
  Eigen::MatrixXd centres(static_cast<Eigen::Index>(cells.size()), 3);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const int x = cells[i] % grid.Counts(0), yz = cells[i] / grid.Counts(0);
    centres.row(static_cast<Eigen::Index>(i)) =
      grid.Point(x, yz % grid.Counts(1), yz / grid.Counts(1));
  }
  const Eigen::VectorXd distances = boundary.Find(centres, progress).Distances;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    double& level = grid.Values(cells[i]);
    level =
      std::copysign(std::min(distances(static_cast<Eigen::Index>(i)), std::abs(level)), level);
  }
}

SampledGrid SampleSolidDistances(
  const Mesh& surface, const SurfaceLocator& boundary, double size, const Progress& progress)
{
  SampledGrid grid = BuildGridAround(surface.Points, size);
  SampleDistances(surface, boundary, grid, progress);
  return grid;
}

namespace
{

/// The maximum distance, in cells, of the surface from the cells on either side of it.
constexpr double CoverReach = 0.7;

/// Returns the levels, in cells, below which a cell counts as inside, in the order of trial.
std::vector<double> GetReaches(VoxelRule rule)
{
  switch (rule)
  {
    case VoxelRule::Centres: // at 0, cells along a plane change together, also at its edges
      return { 0.0, 0.15, -0.15, 0.3 };
    case VoxelRule::Any: // in steps of a tenth, too; the lowest open narrow holes
      return { 0.15, 0.0, 0.3, -0.15, 0.1, -0.1, 0.2, -0.2, -0.3, -0.4, -0.5 };
    case VoxelRule::Connected: // a little above 0 keeps thin parts connected
      break;
  }
  return { 0.15, 0.0, 0.3, -0.15 };
}

/// Returns positions on a surface that are dense relative to cells of this size, for CoverSurface.
Eigen::MatrixXd SampleDensely(const Surface& surface, double size)
{
  constexpr double positionsPerCell = 30.0;
  constexpr unsigned int seed = 1;
  return SampleRandomly(
    surface, static_cast<int>(positionsPerCell * ComputeArea(surface) / (size * size)), seed);
}

/// Returns the number of components of a surface that bound solids from outside.
int CountSolids(const Surface& surface)
{
  const std::vector<Mesh> components = SplitComponents(surface);
  return static_cast<int>(std::count_if(components.begin(), components.end(),
    [](const Mesh& component) { return ComputeEnclosedVolume(component) > 0.0; }));
}

/// Maps a surface to warped space, with edges so short that they may stay straight there. Returns
/// the surface itself if the warp is the identity.
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
  // The layer has more hexahedra than the cells it replaces: the excess was measured as half a
  // cell's volume for each cell face of area.
  double size = std::cbrt(volume / hexahedra);
  // A fixed-point iteration for size = cbrt((volume + area size / 2) / hexahedra).
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
  const Progress& progress, VoxelRule rule)
{
  // 1. SampleDistances: the signed distance at the cells' centres.
  // 2. For each reach in turn: FindVoxelSolid (well-composed cells inside), KeepLargestParts.
  // 3. If they have the topology, CoverSurface adds tips and slots narrower than a cell, which
  //    preserves it. The first cells that are accepted are returned.
  const double size = grid.Spacing;
  const Surface whole = Warp(this->Whole, warp, size);
  const Surface bounding =
    this->Bounding.Crossings == 0 ? whole : Warp(this->Bounding.Surface, warp, size);
  SampledGrid levels = grid;
  SampleDistances(whole, SurfaceLocator(bounding), levels, progress.Part(0.0, 0.6));
  const Eigen::VectorXd distances = levels.Values;
  std::optional<Eigen::MatrixXd> positions;
  const std::vector<double> reaches = GetReaches(rule);
  for (std::size_t i = 0; i < reaches.size(); ++i)
  {
    const double reach = reaches[i];
    const double tried = static_cast<double>(i) / static_cast<double>(reaches.size());
    const Progress part = progress.Part(0.6 + 0.4 * tried, 1.0);
    part(0.0);
    // A cell is inside if its distance is below the reach.
    levels.Values = distances.array() - reach * size;
    WellComposedVoxels solid = FindVoxelSolid(levels);
    if (solid.Pinched > 0)
    {
      continue;
    }
    KeepLargestParts(levels, this->Solids, solid.Inside);
    part(0.1);
    const HexMesh cubes = BuildVoxelHexahedra(levels, solid.Inside);
    if (cubes.Hexahedra.rows() == 0 || !this->HasTopology(cubes))
    {
      continue;
    }
    part(0.15);
    if (!positions)
    {
      positions = SampleDensely(bounding, size);
    }
    CoverSurface(levels, *positions, CoverReach, solid.Inside);
    if (accepts(solid.Inside))
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
  // The topology of a surface that crosses itself is unknown: two successive grids that agree are
  // believed.
  const bool again = this->Before == now;
  this->Before = now;
  return again || this->TakesAny;
}

} // namespace shape
