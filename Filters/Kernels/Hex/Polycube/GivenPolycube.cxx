#include "Hex/Polycube/GivenPolycube.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Hex/Polycube/Private/PolycubeMap.h"
#include "Hex/Voxels/WellComposedVoxels.h"
#include "Mesh/QuadSurface.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"
#include "Solids/GridWinding.h"
#include "Solids/SolidBoundary.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Coordinates that differ by less than this fraction of the polycube's size are equal.
constexpr double Flatness = 1e-6;
/// The maximum distance of sources from the surface, as a fraction of its diagonal.
constexpr double MaximumSourceDistance = 0.02;

/// Returns the coordinates of the faces perpendicular to an axis, ascending. Throws if a triangle
/// is perpendicular to no axis.
std::vector<double> FaceCoordinates(const Mesh& polycube, double size, int axis)
{
  std::vector<double> all;
  for (Eigen::Index t = 0; t < polycube.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(polycube, t);
    if (corners.col(axis).maxCoeff() - corners.col(axis).minCoeff() <= Flatness * size)
    {
      all.push_back(corners.col(axis).mean());
    }
  }
  std::sort(all.begin(), all.end());
  std::vector<double> coordinates;
  for (const double value : all)
  {
    if (coordinates.empty() || value - coordinates.back() > 2.0 * Flatness * size)
    {
      coordinates.push_back(value);
    }
  }
  return coordinates;
}

/// A face perpendicular to an axis has no extent along it.
void RequireAcrossAxes(const Mesh& polycube, double size)
{
  int count = 0;
  Eigen::Index first = -1;
  for (Eigen::Index t = 0; t < polycube.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(polycube, t);
    const Eigen::RowVector3d extent = corners.colwise().maxCoeff() - corners.colwise().minCoeff();
    if (extent.minCoeff() > Flatness * size)
    {
      first = first < 0 ? t : first;
      ++count;
    }
  }
  if (count > 0)
  {
    throw InvalidInput("the Polycube has " + std::to_string(count) +
      " triangles that are not perpendicular to an axis (first triangle " + std::to_string(first) +
      "); give the second output of Shape Polycube, or a surface whose faces are perpendicular to "
      "the axes");
  }
}

/// Returns the greatest length that the faces' coordinates are multiples of. Throws if there is
/// none.
double UnitOf(const Mesh& polycube, double size)
{
  constexpr double minimum = 1e-3; // fraction of the size: at most a thousand cells along it
  double unit = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> coordinates = FaceCoordinates(polycube, size, axis);
    for (std::size_t i = 1; i < coordinates.size(); ++i)
    {
      // Euclid's algorithm, with remainders centred at 0.
      double other = coordinates[i] - coordinates[0];
      while (other > 0.1 * minimum * size)
      {
        const double remainder = std::abs(std::remainder(unit, other));
        unit = other;
        other = remainder;
      }
    }
  }
  if (unit < minimum * size)
  {
    throw InvalidInput(
      "the distances between the Polycube's faces are not integer multiples of one length of at "
      "least a thousandth of its size; move the faces to such multiples");
  }
  return unit;
}

/// Returns the grid of cells in the polycube's bounding box, surrounded by one more layer.
SampledGrid GridIn(const Mesh& polycube, double cell)
{
  const Eigen::RowVector3d low = polycube.Points.colwise().minCoeff();
  const Eigen::RowVector3d sides = polycube.Points.colwise().maxCoeff() - low;
  SampledGrid grid;
  grid.Spacing = cell;
  // Samples are the cells' centres.
  grid.Origin = low.array() - 0.5 * cell;
  grid.Counts = (sides / cell).array().round().cast<int>() + 2;
  return grid;
}

/// Marks the cells with a positive winding number at their centres.
std::vector<char> CellsInside(const Mesh& polycube, const SampledGrid& grid)
{
  const Eigen::VectorXi windings = ComputeGridWindingNumbers(polycube, grid);
  const auto twice = (windings.array() > 1).count();
  if (twice > 0)
  {
    throw InvalidInput("the Polycube overlaps itself in " + std::to_string(twice) +
      " cells; try Shape Polycube with another Compactness");
  }
  std::vector<char> inside(windings.size());
  std::transform(windings.begin(), windings.end(), inside.begin(),
    [](int winding) { return static_cast<char>(winding > 0); });
  return inside;
}

void RequireTopology(const HexMesh& cells, const Surface& surface)
{
  const Topology& wanted = surface.Topology();
  const Topology found = ComputeBoundaryTopology(cells);
  if (found.NonManifoldEdges > 0 || found.NonManifoldPoints > 0)
  {
    throw InvalidInput("the Polycube touches itself at an edge or a point; move its parts apart");
  }
  if (found.EulerNumber != wanted.EulerNumber || found.Components != wanted.Components)
  {
    throw InvalidInput("the Polycube has the Euler number " + std::to_string(found.EulerNumber) +
      " and " + std::to_string(found.Components) + " components, but the Surface has " +
      std::to_string(wanted.EulerNumber) + " and " + std::to_string(wanted.Components) +
      "; give a polycube of this Surface");
  }
}

void RequireSourcesOn(const Eigen::MatrixXd& sources, const Surface& surface)
{
  const double diagonal = ComputeBoxDiagonal(surface.Points());
  Eigen::Index farthest = 0;
  const double distance = SurfaceLocator(surface).Find(sources).Distances.maxCoeff(&farthest);
  if (distance > MaximumSourceDistance * diagonal)
  {
    throw InvalidInput("the Polycube's SourcePosition lies up to " + FormatNumber(distance) +
      " away from the Surface (at point " + std::to_string(farthest) +
      "); give a polycube of this Surface");
  }
}

} // namespace

// 1. The unit of the polycube's coordinates is found and divided into cells (UnitOf).
// 2. The cells inside, by winding numbers, must have the surface's topology.
// 3. The harmonic map that extends the boundary map carries their inner points.
// 4. Their boundary points follow the boundary map itself.
GivenPolycubeCells BuildPolycubeCells(const GivenPolycube& polycube, const Surface& surface,
  double cellSize, int maximum, const Progress& progress)
{
  const Surface given = polycube.Surface;
  RequireClosedSurface(given, "the Polycube");
  if (polycube.Sources.rows() != polycube.Surface.Points.rows() || polycube.Sources.cols() != 3)
  {
    throw InvalidInput(
      "the Polycube's SourcePosition must have 3 components at each point; give the second output "
      "of Shape Polycube");
  }
  RequireFinite(polycube.Sources, "the Polycube's SourcePosition");
  RequireSourcesOn(polycube.Sources, surface);
  const Surface outer = OrientOutwards(given);
  const double size = ComputeLongestBoxEdge(outer.Points());
  RequireAcrossAxes(outer, size);
  const double unit = UnitOf(outer, size), volume = ComputeEnclosedVolume(outer);
  // The polycube may have another scale than the surface.
  const double scale = std::cbrt(volume / std::abs(ComputeEnclosedVolume(surface)));
  const double wanted = cellSize > 0.0 ? cellSize * scale : std::cbrt(volume / AutomaticCells);
  // A whole number of cells in each unit: faces of the polycube are faces of cells.
  const double cell = unit / std::max(1.0, std::round(unit / wanted));
  if (volume / (cell * cell * cell) > maximum)
  {
    throw InvalidInput("the Polycube, whose unit is " + FormatNumber(unit) +
      ", would be divided into more than " + std::to_string(maximum) + " cells; " +
      (cell < unit ? "set a larger CellSize"
                   : "give a Polycube with a larger unit (TargetEdgeLength)"));
  }
  const SampledGrid grid = GridIn(outer, cell);
  GivenPolycubeCells cells;
  cells.Solid = BuildVoxelHexahedra(grid, CellsInside(outer, grid));
  cells.Positions = cells.Solid.Points;
  cells.CellSize = cell / scale;
  cells.Spacing = cell;
  RequireTopology(cells.Solid, surface);

  HarmonicVolumeMapOptions options;
  options.MaximumLevels = 3;
  const HarmonicVolumeMapResult map = ComputeHarmonicVolumeMap(outer, polycube.Sources, {}, options,
    progress.Part(0.0, 0.9, "mapping the polycube to the surface"));
  Eigen::MatrixXd carried = Evaluate(map.Map, cells.Solid.Points);
  // The harmonic map only approximates the boundary map, which puts these points on the surface.
  const Eigen::MatrixXi quads = FindBoundaryQuads(cells.Solid);
  std::vector<int> onBoundary(quads.data(), quads.data() + quads.size());
  std::sort(onBoundary.begin(), onBoundary.end());
  onBoundary.erase(std::unique(onBoundary.begin(), onBoundary.end()), onBoundary.end());
  carried(onBoundary, Eigen::all) =
    PullBack(SurfaceLocator(outer).Find(cells.Solid.Points(onBoundary, Eigen::all)),
      outer.Triangles(), polycube.Sources);
  cells.Solid.Points = std::move(carried);
  progress(1.0);
  return cells;
}

} // namespace shape
