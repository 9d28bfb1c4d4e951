#include "Hex/RegionRemesh.h"

#include "Base/Errors.h"
#include "Hex/Grid/RegionHexes.h"
#include "Labels/LabelSurfaces.h"
#include "Mesh/QuadSurface.h"

#include <Eigen/Geometry>

#include <map>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The number of hexahedra, the volume and the topology of each region.
std::vector<HexRegion> MeasureRegions(const HexFit& fit)
{
  std::map<int, std::vector<int>> rowsOf;
  for (int hex = 0; hex < static_cast<int>(fit.RegionOf.size()); ++hex)
  {
    rowsOf[fit.RegionOf(hex)].push_back(hex);
  }
  std::vector<HexRegion> regions;
  for (const auto& [label, rows] : rowsOf)
  {
    const Mesh boundary{ fit.Solid.Points,
      SplitQuads(FindBoundaryQuads({ fit.Solid.Points, fit.Solid.Hexahedra(rows, Eigen::all) })) };
    const Topology topology = ComputeTopology(boundary);
    regions.push_back({ label, static_cast<int>(rows.size()), ComputeEnclosedVolume(boundary),
      topology.EulerNumber, topology.Components });
  }
  return regions;
}

} // namespace

LabelledSurfaces SeparateLabels(const LabelImage& image, const Progress& progress)
{
  LabelSurfacesResult surfaces = ExtractLabelSurfaces(image, {}, progress);
  LabelledSurfaces regions;
  regions.Surfaces = { std::move(surfaces.Points), std::move(surfaces.Triangles) };
  regions.Labels = std::move(surfaces.Regions);
  const Eigen::Vector3d first = image.Axes.col(0).normalized();
  const Eigen::Vector3d third = first.cross(Eigen::Vector3d(image.Axes.col(1))).normalized();
  regions.Frame << first, third.cross(first), third;
  return regions;
}

HexRemeshResult RemeshRegions(
  const LabelledSurfaces& regions, const HexRemeshOptions& options, const Progress& progress)
{
  RequireInRange(options);
  RequireOneSize(options);
  if (options.Method == HexRemeshOptions::MethodType::Polycube)
  {
    throw InvalidInput("regions that touch need a grid; choose Method Automatic or Grid");
  }
  GridHexesOptions grid;
  static_cast<HexMeshOptions&>(grid) = options;
  if (options.CellsOnLongestSide > 0)
  {
    grid.CellSize = ComputeLongestBoxEdge(regions.Surfaces.Points) / options.CellsOnLongestSide;
  }
  grid.MaximumHexahedra = grid.CellSize > 0.0 ? MaximumOfGivenSize : options.MaximumHexahedra;
  RegionHexesResult hexes = BuildRegionHexahedra(regions, grid, progress);
  if (hexes.Fit.Inverted > 0)
  {
    throw SolveFailure(
      std::to_string(hexes.Fit.Inverted) + " hexahedra stay inverted; set a smaller CellSize");
  }
  HexRemeshResult result;
  result.Fit = std::move(hexes.Fit);
  result.Grid = FindHexGrid(result.Fit, {}, hexes.CellSize, progress.Part(1.0, 1.0));
  result.CellSize = hexes.CellSize;
  result.Reason = "regions that touch need the cells of a grid";
  if (hexes.CellSize < grid.CellSize)
  {
    result.Reason += "; its cells are smaller than given, because " + hexes.WhySmaller;
  }
  result.Regions = MeasureRegions(result.Fit);
  result.Curves = hexes.Curves;
  result.CurvesKept = hexes.CurvesKept;
  result.Junctions = hexes.Junctions;
  result.JunctionsKept = hexes.JunctionsKept;
  result.CurveDistance = hexes.CurveDistance;
  return result;
}

} // namespace shape
