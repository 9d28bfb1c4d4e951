#include "Hex/Voxels/TouchingRegionVoxels.h"

#include "Hex/Voxels/Private/LabelRepair.h"
#include "Hex/Voxels/TopologyPreservingVoxels.h"
#include "Hex/Voxels/WellComposedVoxels.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/QuadSurface.h"
#include "Mesh/RegionSurfaces.h"
#include "Search/ClosestPoint.h"
#include "Solids/GridWinding.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

/// The number of components of a surface whose volume has the sign of `side`.
int CountComponents(const Surface& surface, double side)
{
  const std::vector<Mesh> components = SplitComponents(surface);
  return static_cast<int>(std::count_if(components.begin(), components.end(),
    [&](const Mesh& component) { return side * ComputeEnclosedVolume(component) > 0.0; }));
}

/// The surface of all regions together, facing outwards.
Mesh OuterSurface(const Mesh& surfaces, const Eigen::MatrixXi& labels)
{
  Mesh outer{ surfaces.Points, Eigen::MatrixXi(labels.rows(), 3) };
  Eigen::Index count = 0;
  for (Eigen::Index t = 0; t < labels.rows(); ++t)
  {
    if (labels(t, 0) == RegionSurfaces::Outside)
    {
      outer.Triangles.row(count++) = surfaces.Triangles.row(t).reverse();
    }
    else if (labels(t, 1) == RegionSurfaces::Outside)
    {
      outer.Triangles.row(count++) = surfaces.Triangles.row(t);
    }
  }
  outer.Triangles.conservativeResize(count, 3);
  return outer;
}

/// Which regions share triangles, and which three or more share edges.
RegionMeetings FindMeetings(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXi& numbers, int count)
{
  RegionMeetings meetings;
  meetings.Count = count;
  meetings.Pairs.assign(static_cast<std::size_t>(count) * count, 0);
  const std::vector<HalfEdge> edges = SortHalfEdges(triangles, triangles.maxCoeff() + 1);
  for (Eigen::Index t = 0; t < numbers.rows(); ++t)
  {
    meetings.Pairs[numbers(t, 0) * count + numbers(t, 1)] = 1;
    meetings.Pairs[numbers(t, 1) * count + numbers(t, 0)] = 1;
  }
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end)
  {
    std::vector<int> around;
    for (; end < edges.size() && edges[end].Low() == edges[first].Low() &&
         edges[end].High() == edges[first].High();
         ++end)
    {
      around.push_back(numbers(edges[end].Triangle, 0));
      around.push_back(numbers(edges[end].Triangle, 1));
    }
    if (end - first > 2)
    {
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
      meetings.Around.insert(around);
    }
  }
  return meetings;
}

/// The distances of the centres of cells that are beside another region; other cells are far.
void MeasureDistances(const Mesh& surfaces, const std::vector<int>& regionOf, SampledGrid& grid,
  const Progress& progress)
{
  const int strides[] = { 1, grid.Counts(0), grid.Counts(0) * grid.Counts(1) };
  std::vector<char> isNear(regionOf.size(), 0);
  for (std::size_t cell = 0; cell < regionOf.size(); ++cell)
  {
    for (const int stride : strides)
    {
      const std::size_t next = cell + static_cast<std::size_t>(stride);
      if (next < regionOf.size() && regionOf[cell] != regionOf[next])
      {
        isNear[cell] = isNear[next] = 1;
      }
    }
  }
  std::vector<int> cells;
  for (int cell = 0; cell < static_cast<int>(isNear.size()); ++cell)
  {
    if (isNear[cell])
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
  const Eigen::VectorXd distances =
    SurfaceLocator(Surface(surfaces)).Find(centres, progress).Distances;
  const double far = LevelBand * grid.Spacing;
  grid.Values = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(regionOf.size()), far);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    grid.Values(cells[i]) = distances(static_cast<Eigen::Index>(i));
  }
}

} // namespace

TouchingRegionVoxels::TouchingRegionVoxels(
  const Mesh& surfaces, const Eigen::MatrixXi& labels, const Progress& progress)
  : Whole(surfaces)
  , Bounded(surfaces, labels, progress)
{
  this->Labels = { RegionSurfaces::Outside };
  this->Parts = { 1 + CountComponents(OuterSurface(surfaces, labels), -1.0) };
  std::map<int, int> numberOf = { { RegionSurfaces::Outside, 0 } };
  for (const auto& [label, surface] : this->Bounded.Surfaces())
  {
    numberOf[label] = static_cast<int>(this->Labels.size());
    this->Labels.push_back(label);
    this->Parts.push_back(CountComponents(surface, 1.0));
    this->Wanted[label] = surface.Topology();
  }
  this->Meetings = FindMeetings(surfaces.Triangles,
    labels.unaryExpr([&](int label) { return numberOf.at(label); }),
    static_cast<int>(this->Labels.size()));
}

double TouchingRegionVoxels::CellSizeFor(double hexahedra) const
{
  double volume = 0.0, area = 0.0; // the area of both sides of interfaces
  for (const auto& [label, surface] : this->Bounded.Surfaces())
  {
    volume += this->Bounded.Volumes().at(label);
    area += ComputeArea(surface);
  }
  // The faces of cells along a surface have 1.5 times its area on average over all directions. Each
  // has a hexahedron of a layer and, where regions meet at curves, one of a sheet.
  const double faces = (this->Meetings.Around.empty() ? 1.5 : 3.0) * area;
  double size = std::cbrt(volume / hexahedra);
  for (int step = 0; step < 50; ++step)
  {
    size = std::cbrt((volume + faces * size) / hexahedra);
  }
  return size;
}

// 1. Each cell gets the region whose winding number around its centre is positive.
// 2. RepairRegions and DissolveParts in turn, until nothing changes.
// 3. The topology of each region's cells is compared with that of its surface.
std::optional<LabelledCells> TouchingRegionVoxels::Fill(double size, const Progress& progress)
{
  SampledGrid grid = BuildGridAround(this->Whole.Points, size);
  std::vector<int> regionOf(grid.Counts.cast<std::size_t>().prod(), 0);
  const auto count = static_cast<int>(this->Labels.size());
  for (int number = count - 1; number > 0; --number)
  {
    progress.Part(0.0, 0.4)(1.0 - static_cast<double>(number) / count);
    const Eigen::VectorXi windings =
      ComputeGridWindingNumbers(this->Bounded.Surfaces().at(this->Labels[number]), grid);
    for (Eigen::Index cell = 0; cell < windings.size(); ++cell)
    {
      regionOf[cell] = windings(cell) > 0 ? number : regionOf[cell];
    }
  }
  MeasureDistances(this->Whole, regionOf, grid, progress.Part(0.4, 0.6));
  constexpr int rounds = 5;
  int faulty = 0;
  for (int round = 0; round < rounds; ++round)
  {
    progress(0.6 + 0.3 * round / rounds);
    faulty = RepairRegions(grid, this->Meetings, regionOf);
    if (DissolveParts(grid, this->Parts, regionOf) == 0)
    {
      break;
    }
  }
  if (faulty > 0)
  {
    this->Wrong = "regions touch themselves at " + std::to_string(faulty) + " corners of cells";
    return std::nullopt;
  }
  std::vector<char> inside(regionOf.size());
  std::transform(regionOf.begin(), regionOf.end(), inside.begin(),
    [](int number) { return static_cast<char>(number > 0); });
  LabelledCells cells;
  cells.CellSize = size;
  cells.Solid = BuildVoxelHexahedra(grid, inside);
  cells.RegionOf.resize(cells.Solid.Hexahedra.rows());
  Eigen::Index hex = 0;
  for (const int number : regionOf)
  {
    if (number > 0)
    {
      cells.RegionOf(hex++) = this->Labels[number];
    }
  }
  progress(0.9);
  if (!this->HaveTopology(cells))
  {
    return std::nullopt;
  }
  progress(1.0);
  return cells;
}

bool TouchingRegionVoxels::HaveTopology(const LabelledCells& cells)
{
  for (const auto& [label, wanted] : this->Wanted)
  {
    std::vector<int> rows;
    for (int hex = 0; hex < static_cast<int>(cells.RegionOf.size()); ++hex)
    {
      if (cells.RegionOf(hex) == label)
      {
        rows.push_back(hex);
      }
    }
    const HexMesh region{ cells.Solid.Points, cells.Solid.Hexahedra(rows, Eigen::all) };
    const Topology found = rows.empty() ? Topology() : ComputeBoundaryTopology(region);
    if (found.EulerNumber != wanted.EulerNumber || found.Components != wanted.Components ||
      found.NonManifoldEdges > 0 || found.NonManifoldPoints > 0)
    {
      this->Wrong = "the surface of region " + std::to_string(label) + " has Euler number " +
        std::to_string(wanted.EulerNumber) + " and " + std::to_string(wanted.Components) +
        " component(s), its cells have " + std::to_string(found.EulerNumber) + " and " +
        std::to_string(found.Components);
      return false;
    }
  }
  this->Wrong.clear();
  return true;
}

} // namespace shape
