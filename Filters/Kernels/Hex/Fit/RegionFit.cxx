#include "Hex/Fit/RegionFit.h"

#include "Hex/Features/FeatureConstraint.h"
#include "Hex/Features/RegionNetwork.h"
#include "Hex/Fit/InnerInterfaces.h"
#include "Hex/Fit/Private/Settling.h"

#include <memory>
#include <utility>

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

} // namespace

RegionFit FitRegions(const LabelledCells& cells, const Mesh& surfaces,
  const Eigen::MatrixXi& labels, const HexFitOptions& options, double maximumDistance,
  const Progress& progress)
{
  RegionFit result;
  HexFit& fit = result.Fit;
  fit.Solid = cells.Solid;
  const RegionFaces faces = FindRegionFaces(cells.Solid, cells.RegionOf);
  progress(0.0);
  RegionMatch match = MatchRegions(cells.Solid, faces, surfaces, labels);
  progress(0.0);
  result.Curves = match.Curves;
  result.CurvesKept = match.CurvesKept;
  result.Corners = match.Corners;
  result.CornersKept = match.CornersKept;
  const InterfaceLayers layers(fit.Solid, cells.RegionOf, options.PaddingLayers);
  fit.RegionOf = layers.Regions(fit.Solid.Hexahedra.rows());
  const Surface surface(surfaces);
  fit.Constraint = std::make_shared<FeatureConstraint>(
    surface, SurfaceFeatures(), match.Boundary, fit.Solid.Points.rows());
  for (const auto& [point, position] : match.Boundary.Starts)
  {
    fit.Solid.Points.row(point) = position;
  }
  constexpr int smoothings = 30; // curves are bent where they meet
  // Where interfaces meet at small angles, more is rarely possible.
  constexpr double wanted = 0.4;
  Settle(
    fit.Solid, *fit.Constraint, [&](Eigen::MatrixXd& points) { layers.Spread(points); },
    { smoothings, options.RaisedFrom, wanted }, progress.Part(0.0, 0.8));
  WriteFaces(faces, fit);
  Judge(fit);
  RelaxBoundaryAroundBad(fit, surface, maximumDistance, progress.Part(0.8, 1.0), wanted);
  progress(1.0);
  return result;
}

} // namespace shape
