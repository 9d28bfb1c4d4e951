#include "Hex/Fit/RegionFit.h"

#include "Distance/HausdorffDistance.h"
#include "Hex/Features/FeatureConstraint.h"
#include "Hex/Features/RegionMatch.h"
#include "Hex/Fit/InnerInterfaces.h"
#include "Hex/Fit/Private/RegionSheets.h"
#include "Hex/Fit/Private/Settling.h"
#include "Mesh/RegionSurfaces.h"
#include "Quality/ScaledJacobian.h"

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

/// The minimum scaled Jacobian of the hexahedra that are not near curves where interfaces meet.
double FindMinimumAwayFromCurves(const RegionFit& result)
{
  std::vector<char> marked(result.Fit.Solid.Points.rows(), 0);
  for (const int point : result.CurvePoints)
  {
    marked[point] = 1;
  }
  constexpr int rings = 2; // the layers along the interfaces
  GrowRings(result.Fit.Solid.Hexahedra, rings, marked);
  std::vector<int> near;
  for (int point = 0; point < static_cast<int>(marked.size()); ++point)
  {
    if (marked[point])
    {
      near.push_back(point);
    }
  }
  return FindMinimumScaledJacobianAwayFrom(near, result.Fit.Solid);
}

} // namespace

bool IsGood(const RegionFit& result)
{
  const bool isComplete =
    result.CurvesKept == result.Curves && result.JunctionsKept == result.Junctions;
  return result.Fit.Inverted == 0 &&
    (result.Fit.MinimumScaledJacobian >= GoodScaledJacobian ||
      (isComplete && FindMinimumAwayFromCurves(result) >= GoodScaledJacobian));
}

RegionFit FitRegions(const LabelledCells& cells, const RegionTargets& targets,
  const HexFitOptions& options, double maximumDistance, const Progress& progress)
{
  RegionFit result;
  HexFit& fit = result.Fit;
  fit.Solid = cells.Solid;
  fit.Core = cells.Solid.Hexahedra;
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
  SettlingOptions settling;
  settling.Smoothings = 30; // curves are bent where they meet
  // Most cells are cubes already: more sweeps raise the mean scaled Jacobian by less than 0.01, and
  // not the minimum.
  settling.Sweeps = 3;
  settling.RaisedFrom = options.RaisedFrom;
  settling.RaisedTo = 0.4; // where interfaces meet at small angles, more is rarely possible
  if (options.Draft)
  {
    SettleAsDraft(settling);
  }
  Settle(
    fit.Solid, *fit.Constraint, [&](Eigen::MatrixXd& points) { layers.Spread(points); }, settling,
    progress.Part(0.0, 0.8));
  WriteFaces(faces, fit);
  Judge(fit);
  for (const RegionNetwork::Curve& chain : match.Chains.Curves)
  {
    result.CurvePoints.insert(result.CurvePoints.end(), chain.Points.begin(), chain.Points.end());
  }
  // Points leave the surfaces for a scaled Jacobian that the hexahedra need, or, if all are good
  // enough, only if some are inverted.
  const double needed = options.Draft || IsGood(result) ? 0.0 : GoodScaledJacobian;
  RelaxBoundaryAroundBad(fit, targets.Surfaces, maximumDistance, progress.Part(0.8, 1.0), needed);
  result.CurveDistance = ComputeCurveDistance(fit.Solid.Points, targets, match);
  fit.InnerDistance = MeasureInterfaces(fit, targets);
  progress(1.0);
  return result;
}

} // namespace shape
