#include "Hex/Polycube/PolycubeHexes.h"

#include "Base/Errors.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Hex/Polycube/Private/Charts.h"
#include "Hex/Polycube/Private/IntegerMapHexes.h"
#include "Hex/Polycube/Private/PolycubeMap.h"
#include "Hex/Polycube/Private/VoxelPolycube.h"
#include "Mesh/QuadSurface.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Quality/ScaledJacobian.h"
#include "Solids/SolidBoundary.h"

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

/// If the worst hexahedron of a polycube with charts is worse than this, a grid is tried, too.
constexpr double MinimumAccepted = 0.2;

/// Hexahedra of a polycube before they are optimised.
struct Cubes
{
  HexMesh Solid;
  Eigen::MatrixXd Positions; ///< n x 3: on the polycube
  double CellSize;
  PolycubeHexesResult::MapType Map;
  bool Overlaps;
};

int CountInverted(const HexMesh& mesh)
{
  return static_cast<int>((ComputeScaledJacobians(mesh).array() <= 0.0).count());
}

std::vector<char> OnBoundary(const HexMesh& mesh)
{
  std::vector<char> on(mesh.Points.rows(), 0);
  const Eigen::MatrixXi quads = FindBoundaryQuads(mesh);
  for (const int point : quads.reshaped())
  {
    on[point] = 1;
  }
  return on;
}

/// Returns the cells of the polycube, mapped by the better of two maps.
Cubes CubesOfMap(const PolycubeMap& map, const Progress& progress)
{
  IntegerMapHexesResult hexes =
    ExtractIntegerMapHexahedra(map.Solid.Points, map.Positions, map.Solid.Tetrahedra);
  Cubes cubes{ std::move(hexes.Solid), std::move(hexes.Positions), map.CellSize,
    PolycubeHexesResult::MapType::Tetrahedra, hexes.Overlaps };
  if (cubes.Overlaps)
  {
    return cubes;
  }
  HarmonicVolumeMapOptions options;
  options.MaximumLevels = 3;
  const HarmonicVolumeMapResult harmonic = ComputeHarmonicVolumeMap(
    map.Solid.Surface(map.Positions), map.Solid.Surface().Points, {}, options, progress);
  const Eigen::MatrixXd carried = Evaluate(harmonic.Map, cubes.Positions);
  HexMesh other{ cubes.Solid.Points, cubes.Solid.Hexahedra };
  const std::vector<char> outer = OnBoundary(other);
  for (Eigen::Index i = 0; i < other.Points.rows(); ++i)
  {
    // Boundary points stay where the tetrahedra put them, on the surface.
    if (!outer[i] && carried.row(i).allFinite())
    {
      other.Points.row(i) = carried.row(i);
    }
  }
  if (CountInverted(other) <= CountInverted(cubes.Solid))
  {
    cubes.Solid = std::move(other);
    cubes.Map = PolycubeHexesResult::MapType::Harmonic;
  }
  return cubes;
}

/// Returns the cells of a polycube with charts; nothing, and the reason in `why`, if none is
/// usable.
std::optional<Cubes> CubesOfCharts(const Surface& surface, const PolycubeHexesOptions& options,
  std::string& why, const Progress& progress)
{
  const Topology wanted = RequireClosedSurface(surface, "the surface");
  try
  {
    PolycubeMapOptions mapOptions;
    mapOptions.CellSize = options.CellSize;
    const PolycubeMap map =
      FindPolycubeMap(surface, options.Compactness, mapOptions, progress.Part(0.0, 0.7));
    Cubes cubes = CubesOfMap(map, progress.Part(0.7, 1.0, "mapping the polycube to the surface"));
    if (HasBoundaryTopology(cubes.Solid, wanted) &&
      cubes.Solid.Hexahedra.rows() <= options.MaximumHexahedra)
    {
      return cubes;
    }
    why = "the polycube has too many cells, or they do not have the topology of the surface";
  }
  catch (const SolveFailure& failure)
  {
    why = failure.what();
  }
  return std::nullopt;
}

/// The cells of a grid in the deformed solid, if there is no good polycube with charts.
Cubes CubesOfVoxels(
  const Surface& surface, const PolycubeHexesOptions& options, const Progress& progress)
{
  const double cells = options.CellSize > 0.0
    ? ComputeEnclosedVolume(surface) / std::pow(options.CellSize, 3)
    : AutomaticCells;
  VoxelPolycube voxels = FindVoxelPolycube(surface, options.Compactness,
    static_cast<int>(std::clamp<double>(cells, 1.0, options.MaximumHexahedra)),
    options.MaximumHexahedra, progress);
  return { std::move(voxels.Solid), std::move(voxels.Positions), voxels.CellSize,
    PolycubeHexesResult::MapType::Voxels, false };
}

/// The points that triangles use, and the triangles with renumbered points.
Mesh Compacted(const Eigen::MatrixXd& points, Eigen::MatrixXi triangles, Eigen::VectorXi& used)
{
  std::vector<int> number(points.rows(), -1), kept;
  for (Eigen::Index i = 0; i < triangles.size(); ++i)
  {
    int& point = triangles.data()[i];
    if (number[point] < 0)
    {
      number[point] = static_cast<int>(kept.size());
      kept.push_back(point);
    }
    point = number[point];
  }
  used = Eigen::Map<const Eigen::VectorXi>(kept.data(), static_cast<Eigen::Index>(kept.size()));
  return { points(used, Eigen::all), std::move(triangles) };
}

/// Adds the layers, optimises, and describes the polycube's charts.
PolycubeHexesResult FitCubes(const Cubes& cubes, const Surface& surface,
  const PolycubeHexesOptions& options, const Progress& progress)
{
  PolycubeHexesResult result;
  result.Features = FindFeatures(surface, options, cubes.CellSize);
  HexFitOptions fitting{ options.PaddingLayers, options.MaximumHexahedra };
  fitting.FurtherFits = 0;
  fitting.NeedsCreases = options.NeedsCreases;
  result.Fit = FitHexahedra(cubes.Solid, surface, result.Features, fitting, progress);
  // Boundary points remain boundary points.
  Eigen::VectorXi points;
  result.Polycube = Compacted(cubes.Positions, SplitQuads(FindBoundaryQuads(cubes.Solid)), points);
  result.Targets = result.Fit.Solid.Points(points, Eigen::all);
  Eigen::VectorXi labels(result.Polycube.Triangles.rows());
  for (Eigen::Index f = 0; f < labels.size(); ++f)
  {
    labels(f) = FindPolygonLabel(GetCorners(result.Polycube, f));
  }
  const Charts charts = FindCharts(result.Polycube, labels);
  result.Charts = charts.Count();
  result.Corners = static_cast<int>(std::count_if(charts.AtPoint.begin(), charts.AtPoint.end(),
    [](const std::vector<int>& around) { return around.size() > 2; }));
  result.Positions = cubes.Positions;
  result.CellSize = cubes.CellSize;
  result.Map = cubes.Map;
  result.Overlaps = cubes.Overlaps;
  return result;
}

} // namespace

// 1. CubesOfCharts: the unit cells of a polycube with charts, mapped into the solid.
// 2. FitCubes: layers around them follow the surface and its creases.
// 3. If there is no such polycube, or its worst hexahedron is bad, the same with the cells of a
//    grid (CubesOfVoxels). The better result is kept.
PolycubeHexesResult BuildPolycubeHexahedra(
  const Surface& given, const PolycubeHexesOptions& options, const Progress& progress)
{
  const Surface surface = OrientOutwards(given);
  RequireInRange(options);
  std::string why;
  const std::optional<Cubes> cubes = CubesOfCharts(surface, options, why, progress.Part(0.0, 0.55));
  std::optional<PolycubeHexesResult> result;
  if (cubes)
  {
    result = FitCubes(
      *cubes, surface, options, progress.Part(0.55, 0.8, "fitting the hexahedra to the surface"));
  }
  if (!result || result->Fit.MinimumScaledJacobian < MinimumAccepted)
  {
    try
    {
      const Cubes voxels = CubesOfVoxels(
        surface, options, progress.Part(0.8, 0.88, "filling the deformed solid with a grid"));
      PolycubeHexesResult other = FitCubes(
        voxels, surface, options, progress.Part(0.88, 1.0, "fitting the hexahedra to the surface"));
      if (!result || other.Fit.MinimumScaledJacobian > result->Fit.MinimumScaledJacobian)
      {
        result = std::move(other);
      }
    }
    catch (const SolveFailure& failure)
    {
      if (!result)
      {
        throw SolveFailure(why + "; " + failure.what());
      }
    }
  }
  progress(1.0);
  return std::move(*result);
}

} // namespace shape
