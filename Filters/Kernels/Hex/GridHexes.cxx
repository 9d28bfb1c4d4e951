#include "Hex/GridHexes.h"

#include "Core/Errors.h"
#include "Core/Topology.h"
#include "Geometry/SignedDistance.h"
#include "Hex/HexOptimization.h"
#include "Hex/OnSurface.h"
#include "Hex/VoxelSolid.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// How far outside, in cells, the centre of a cell may lie that counts as inside: with a little,
/// thin parts stay whole.
constexpr double Reaches[] = { 0.15, 0.0, 0.3, -0.15 };
/// By which cells become smaller where the topology is not the surface's.
constexpr double Shrinkage = 0.85;
constexpr double AutomaticHexahedra = 16000.0;

/// The size of cells of which a solid has so many, those of the layer around them included.
double CellSizeFor(const Mesh& surface, double hexahedra)
{
  const double volume = EnclosedVolume(surface);
  const double area = 0.5 * AreaVectors(surface).rowwise().norm().sum();
  // The layer has more hexahedra than the cells whose room it takes: half a cell's volume for each
  // cell's area was measured.
  double size = std::cbrt(volume / hexahedra);
  for (int step = 0; step < 50; ++step)
  {
    size = std::cbrt((volume + 0.5 * area * size) / hexahedra);
  }
  return size;
}

/// The signed distance at the centres of cells around a surface.
SampledGrid SampleDistance(const SignedDistance& distance, double size, const Progress& progress)
{
  const Eigen::MatrixXd& points = distance.Locator().Surface().Points;
  const Eigen::RowVector3d low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
  SampledGrid grid;
  grid.Spacing = size;
  grid.Counts = ((high - low) / size).array().ceil().cast<int>() + 3;
  grid.Origin = 0.5 * (low + high) - 0.5 * size * (grid.Counts.array() - 1).matrix().cast<double>();
  Eigen::MatrixXd centres(grid.Counts.prod(), 3);
  for (int z = 0; z < grid.Counts(2); ++z)
  {
    for (int y = 0; y < grid.Counts(1); ++y)
    {
      for (int x = 0; x < grid.Counts(0); ++x)
      {
        centres.row(grid.Index(x, y, z)) = grid.Point(x, y, z);
      }
    }
  }
  grid.Values = distance.Evaluate(centres, progress).Distances;
  return grid;
}

/// How many components of a surface bound solids from outside.
int CountSolids(const Mesh& surface)
{
  const std::vector<Mesh> components = SplitComponents(surface);
  return static_cast<int>(std::count_if(components.begin(), components.end(),
    [](const Mesh& component) { return EnclosedVolume(component) > 0.0; }));
}

/// The cubes of a grid that have the surface's topology, if there are such.
std::optional<HexMesh> CubesOf(const SampledGrid& distances, const Topology& wanted, int solids)
{
  for (const double reach : Reaches)
  {
    SampledGrid levels = distances;
    levels.Values.array() -= reach * levels.Spacing;
    VoxelSolid solid = FindVoxelSolid(levels);
    if (solid.Pinched > 0)
    {
      continue;
    }
    KeepLargestParts(levels, solids, solid.Inside);
    HexMesh cubes = VoxelHexahedra(levels, solid.Inside);
    if (cubes.Hexahedra.rows() == 0)
    {
      continue;
    }
    const Topology topology = SurfaceTopology({ cubes.Points, SplitQuads(BoundaryQuads(cubes)) });
    if (topology.EulerNumber == wanted.EulerNumber && topology.Components == wanted.Components)
    {
      return cubes;
    }
  }
  return std::nullopt;
}

} // namespace

GridHexesResult GridHexes(
  const Mesh& surface, const GridHexesOptions& options, const Progress& progress)
{
  if (!std::isfinite(options.CellSize) || options.CellSize < 0.0)
  {
    throw InvalidInput("CellSize is " + std::to_string(options.CellSize) +
      "; it must be positive, or 0 for an automatic one");
  }
  if (options.MaximumHexahedra < 1)
  {
    throw InvalidInput("MaximumHexahedra must be at least 1");
  }
  const Topology topology = RequireClosedSurface(surface, "the surface");
  const double least = CellSizeFor(surface, options.MaximumHexahedra);
  double size = options.CellSize > 0.0
    ? options.CellSize
    : CellSizeFor(surface, std::min<double>(AutomaticHexahedra, options.MaximumHexahedra));
  if (size < least)
  {
    throw InvalidInput("CellSize is " + std::to_string(size) + ", which makes more than " +
      std::to_string(options.MaximumHexahedra) + " hexahedra; at least " + std::to_string(least) +
      " is needed, or a greater MaximumHexahedra");
  }
  const SignedDistance distance(surface);
  const int solids = CountSolids(surface);
  std::optional<HexMesh> cubes;
  for (int attempt = 1; !cubes; ++attempt, size *= Shrinkage)
  {
    if (size < least)
    {
      throw SolveFailure("no grid of " + std::to_string(options.MaximumHexahedra) +
        " hexahedra has the surface's Euler number " + std::to_string(topology.EulerNumber) +
        " and number of components " + std::to_string(topology.Components) +
        ": some part or gap is thinner than its cells; raise MaximumHexahedra, or thicken it");
    }
    const Progress part =
      progress.Part(0.1 * (1.0 - 1.0 / attempt), 0.1 * (1.0 - 1.0 / (attempt + 1)));
    cubes = CubesOf(SampleDistance(distance, size, part), topology, solids);
  }
  GridHexesResult result;
  result.CellSize = size / Shrinkage;
  result.Solid = std::move(*cubes);
  const std::vector<int> outer = AddPadding(result.Solid);
  std::vector<char> on(result.Solid.Points.rows(), 0);
  for (const int point : outer)
  {
    on[point] = 1;
  }
  const OnSurface constraint(distance.Locator(), on);
  constexpr int smoothings = 2;
  SmoothHexahedra(result.Solid, constraint, smoothings);
  OptimizeHexahedra(result.Solid, constraint, {}, progress.Part(0.1, 1.0));
  const Eigen::VectorXd quality = ScaledJacobians(result.Solid);
  result.LeastScaledJacobian = quality.minCoeff();
  result.MeanScaledJacobian = quality.mean();
  result.Inverted = static_cast<int>((quality.array() <= 0.0).count());
  return result;
}

} // namespace shape
