#include "Hex/Fit/RegionFit.h"

#include "Distance/HausdorffDistance.h"
#include "Hex/Features/FeatureConstraint.h"
#include "Hex/Features/RegionMatch.h"
#include "Hex/Fit/InnerInterfaces.h"
#include "Hex/Fit/Private/RegionSheets.h"
#include "Hex/Fit/Private/Settling.h"
#include "Mesh/RegionSurfaces.h"

#include <memory>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Divides the faces into those of the boundary, with a patch for each pair of labels, and the
/// interfaces between each pair of regions.
void WriteFaces(const RegionFaces& faces, HexFit& fit)
{
  fit.Quads = faces.Quads.topRows(faces.Outer);
  fit.QuadRegions = faces.Labels;
  fit.PatchOf.resize(faces.Outer);
  int patch = -1;
  for (Eigen::Index begin = 0, end = 0; begin < faces.Quads.rows(); begin = end)
  {
    const Eigen::RowVector2i pair = faces.Labels.row(begin);
    while (end < faces.Quads.rows() && faces.Labels.row(end) == pair)
    {
      ++end;
    }
    if (begin < faces.Outer)
    {
      fit.PatchOf.segment(begin, end - begin).setConstant(++patch);
    }
    else
    {
      fit.Interfaces.emplace_back(faces.Quads.middleRows(begin, end - begin));
    }
  }
}

/// Returns the larger one-sided Hausdorff distance between the interfaces and their surfaces.
double MeasureInterfaces(const HexFit& fit, const RegionTargets& targets)
{
  const Eigen::MatrixXi& labels = targets.Labels;
  std::vector<int> inner;
  for (int t = 0; t < static_cast<int>(labels.rows()); ++t)
  {
    if (labels(t, 0) != RegionSurfaces::Outside && labels(t, 1) != RegionSurfaces::Outside)
    {
      inner.push_back(t);
    }
  }
  const Eigen::Index outer = fit.Quads.rows(), count = fit.QuadRegions.rows() - outer;
  if (inner.empty() || count == 0)
  {
    return 0.0;
  }
  Eigen::MatrixXi quads(count, 4);
  Eigen::Index row = 0;
  for (const Eigen::MatrixXi& interface : fit.Interfaces)
  {
    quads.middleRows(row, interface.rows()) = interface;
    row += interface.rows();
  }
  return ComputeHausdorffDistance(
    { targets.Surfaces.Points(), targets.Surfaces.Triangles()(inner, Eigen::all) },
    { fit.Solid.Points, SplitQuads(quads) })
    .Larger();
}

} // namespace

RegionFit FitRegions(const LabelledCells& cells, const RegionTargets& targets,
  const HexFitOptions& options, double maximumDistance, const Progress& progress)
{
  RegionFit result;
  HexFit& fit = result.Fit;
  fit.Solid = cells.Solid;
  std::vector<int> regions(cells.RegionOf.begin(), cells.RegionOf.end());
  InsertRegionSheets(fit.Solid, regions, targets, cells.CellSize);
  progress(0.0);
  fit.RegionOf =
    Eigen::Map<const Eigen::VectorXi>(regions.data(), static_cast<Eigen::Index>(regions.size()));
  const RegionFaces faces = FindRegionFaces(fit.Solid, fit.RegionOf);
  RegionMatch match = MatchRegions(fit.Solid, faces, targets, cells.CellSize);
  progress(0.0);
  result.Curves = match.Curves;
  result.CurvesKept = match.CurvesKept;
  result.Junctions = match.Junctions;
  result.JunctionsKept = match.JunctionsKept;
  const InterfaceLayers layers(fit.Solid, fit.RegionOf, options.PaddingLayers);
  fit.RegionOf = layers.Regions(fit.Solid.Hexahedra.rows());
  fit.Constraint = std::make_shared<FeatureConstraint>(
    targets.Surfaces, SurfaceFeatures(), match.Boundary, fit.Solid.Points.rows());
  for (const auto& [point, position] : match.Boundary.Starts)
  {
    fit.Solid.Points.row(point) = position;
  }
  constexpr int smoothings = 30; // curves are bent where they meet
  // Where interfaces meet at small angles, more is rarely possible. Points leave the surfaces only
  // for a scaled Jacobian that the hexahedra need.
  constexpr double wanted = 0.4, needed = 0.3;
  Settle(
    fit.Solid, *fit.Constraint, [&](Eigen::MatrixXd& points) { layers.Spread(points); },
    { smoothings, options.RaisedFrom, wanted }, progress.Part(0.0, 0.8));
  WriteFaces(faces, fit);
  Judge(fit);
  RelaxBoundaryAroundBad(fit, targets.Surfaces, maximumDistance, progress.Part(0.8, 1.0), needed);
  for (const RegionNetwork::Curve& chain : match.Chains.Curves)
  {
    result.CurvePoints.insert(result.CurvePoints.end(), chain.Points.begin(), chain.Points.end());
  }
  result.CurveDistance = ComputeCurveDistance(fit.Solid.Points, targets, match);
  fit.InnerDistance = MeasureInterfaces(fit, targets);
  progress(1.0);
  return result;
}

} // namespace shape
