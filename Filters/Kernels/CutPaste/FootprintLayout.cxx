#include "CutPaste/FootprintLayout.h"

#include "Base/Errors.h"
#include "CutPaste/PasteTarget.h"
#include "CutPaste/PointTarget.h"
#include "ExponentialMap/ConformalPatch.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Fill/FillHoles.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/Extent.h"
#include "Search/ClosestPoint.h"
#include "Search/TriangleWalk.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

namespace shape
{
namespace
{

/// Returns the rows of points in a patch; empty if one of them is not in it.
std::vector<int> RowsOf(const std::vector<int>& points, const ExponentialPatch& patch)
{
  std::unordered_map<int, int> rows;
  for (std::size_t i = 0; i < patch.Points.size(); ++i)
  {
    rows[patch.Points[i]] = static_cast<int>(i);
  }
  std::vector<int> found;
  for (const int point : points)
  {
    const auto row = rows.find(point);
    if (row == rows.end())
    {
      return {};
    }
    found.push_back(row->second);
  }
  return found;
}

/// Returns whether the loop returns to its position if it is pasted where it was cut.
/// Schmidt and Singh, section 4.2, demand it: a feature that is dropped back in its position gives
/// the original surface. It is tested by pasting, with the same code, the loop only.
bool StaysInPlace(PasteTarget& home, const FeatureFootprint& base, const std::vector<int>& loop,
  const Eigen::RowVector3d& seed, const Progress& progress)
{
  constexpr double tolerance = 1e-9; // of the diagonal
  const Surface& surface = home.Surface();
  try
  {
    const LoopOnTarget landing = home.Land(base, { seed, 0.0, 1.0 }, false, progress);
    return IsSimplePolygon(base.LoopPositions) &&
      (landing.Positions - surface.Points()(loop, Eigen::all)).rowwise().norm().maxCoeff() <=
      tolerance * ComputeBoxDiagonal(surface);
  }
  catch (const InvalidInput&) // it does not fit
  {
    return false;
  }
}

/// Flattens the loop conformally, with the smallest sufficient patch; if none is, by the slow
/// method.
/// A larger patch moves the boundary of the map, where it distorts most, away from the loop. The
/// method with minimum distortion is slow, so it comes last.
void LayOutConformally(PasteTarget& home, const Eigen::RowVector3d& seed, double radius,
  const std::vector<int>& loop, FeatureFootprint& base, const Progress& progress)
{
  const ClosestPoint position = home.Layout().Locator().FindOne(seed);
  double left = 1.0; // of the progress: most loops need few attempts
  for (const bool refine : { false, true })
  {
    for (const double share : { 1.02, 1.1, 1.25, 1.5 })
    {
      const Progress part = progress.Part(1.0 - left, 1.0 - 0.5 * left);
      left *= 0.5;
      try
      {
        const ExponentialPatch flat = FlattenPatchConformally(home.Surface(),
          home.Layout().Around(
            position, share * radius, Eigen::RowVector3d::Zero(), part.Part(0.0, 0.1)),
          refine, part.Part(0.1, 0.5));
        const std::vector<int> rows = RowsOf(loop, flat);
        FeatureFootprint other = base;
        other.LoopPositions = flat.Positions(rows, Eigen::all);
        other.ConformalRadius = share * radius;
        other.IsRefined = refine;
        if (!rows.empty() && StaysInPlace(home, other, loop, seed, part.Part(0.5, 1.0)))
        {
          base = std::move(other);
          base.ReturnsInPlace = true;
          return;
        }
      }
      catch (const SolveFailure&) // the next one may succeed
      {
      }
    }
  }
}

/// Returns a patch around the loop's seed that contains the loop, and the rows of the loop's points
/// in it.
std::pair<std::vector<int>, ExponentialPatch> FlattenLoop(
  ExponentialMap& map, const FilledLoop& loop, const Progress& progress)
{
  const ClosestPoint position = map.Locator().FindOne(loop.Seed);
  double radius = 0.0;
  for (const int point : loop.On)
  {
    radius = std::max(radius, (map.Surface().Points().row(point) - position.Position).norm());
  }
  // Paths on the surface are longer than straight lines: the patch grows until it has the loop.
  // The radius grows by 1.5^8 = 26 in total; a loop beyond that is on another component.
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round)
  {
    radius *= 1.5;
    ExponentialPatch patch = map.Around(position, radius, Eigen::RowVector3d::Zero(), progress);
    std::vector<int> rows = RowsOf(loop.On, patch);
    if (!rows.empty())
    {
      return { std::move(rows), std::move(patch) };
    }
  }
  throw InvalidInput("the feature's loop is on another component of the surface than the centre of "
                     "the fill; keep one component with Connectivity");
}

} // namespace

Eigen::RowVector3d FindCenterOfTriangles(const Surface& surface, const std::vector<int>& triangles)
{
  const Surface part(surface.Points(), surface.Triangles()(triangles, Eigen::all));
  const Eigen::VectorXd areas = part.AreaVectors().rowwise().norm();
  const Eigen::MatrixXd midpoints = ComputeCentroids(part);
  // Triangles without area have no weight; if all have none, their mean is taken.
  const Eigen::RowVector3d centroid = areas.sum() > 0.0
    ? Eigen::RowVector3d(areas.transpose() * midpoints / areas.sum())
    : Eigen::RowVector3d(midpoints.colwise().mean());
  // The centroid of a curved fill is not on it.
  return SurfaceLocator(part).FindOne(centroid).Position;
}

FeatureFootprint BuildFootprintOnPoints(
  PointTarget& home, const FilledLoop& loop, const Progress& progress)
{
  const auto [rows, patch] = FlattenLoop(home.Layout(), loop, progress.Part(0.0, 0.5));
  FeatureFootprint base{ loop.Loop, patch.Positions(rows, Eigen::all),
    home.Sampled().Normals(loop.On, Eigen::all), patch.Seed.Normal, patch.Seed.XAxis, loop.Seed };
  base.ReturnsInPlace = IsSimplePolygon(base.LoopPositions) &&
    home.Land(base, { loop.Seed, 0.0, 1.0 }, progress.Part(0.5, 1.0)).Positions ==
      home.Surface().Points()(loop.On, Eigen::all);
  return base;
}

std::vector<FeatureFootprint> BuildFootprintsOnSurface(
  const Surface& filled, const std::vector<FilledLoop>& loops, const Progress& progress)
{
  // Features are pasted on manifolds only: on another surface there is no position to return to.
  std::optional<PasteTarget> home;
  std::optional<ExponentialMap> alone;
  const Topology& kind = filled.Topology();
  if (kind.NonManifoldEdges + kind.NonManifoldPoints + kind.MisorientedEdges == 0)
  {
    home.emplace(filled, ExponentialMapOptions(), progress.Part(0.0, 0.2));
  }
  else
  {
    alone.emplace(filled, ExponentialMapOptions(), progress.Part(0.0, 0.2));
  }
  ExponentialMap& map = home ? home->Layout() : *alone;
  std::vector<FeatureFootprint> bases;
  const auto count = static_cast<double>(loops.size());
  for (const FilledLoop& loop : loops)
  {
    const auto done = static_cast<double>(bases.size());
    const Progress part = progress.Part(0.2 + 0.8 * done / count, 0.2 + 0.8 * (done + 1.0) / count);
    const auto [rows, patch] = FlattenLoop(map, loop, part.Part(0.0, 0.1));
    FeatureFootprint base{ loop.Loop, patch.Positions(rows, Eigen::all),
      GetVertexNormals(filled)(loop.On, Eigen::all), patch.Seed.Normal, patch.Seed.XAxis,
      loop.Seed };
    base.ReturnsInPlace =
      home && StaysInPlace(*home, base, loop.On, loop.Seed, part.Part(0.1, 0.4));
    if (home && !base.ReturnsInPlace)
    {
      LayOutConformally(
        *home, loop.Seed, patch.Distances(rows).maxCoeff(), loop.On, base, part.Part(0.4, 1.0));
    }
    bases.push_back(std::move(base));
  }
  return bases;
}

/// Schmidt and Singh, section 4.2: for an arbitrary feature the loop is embedded in the plane by
/// the hole filler's technique.
FeatureFootprint BuildFootprintOnOwnFill(
  const Surface& feature, const std::vector<int>& loop, const Progress& progress)
{
  const Surface curve(feature.Points()(loop, Eigen::all), Eigen::MatrixXi(0, 3));
  std::vector<int> rim(loop.size());
  std::iota(rim.begin(), rim.end(), 0);
  const TriangleFans fans(feature.Triangles(), feature.Points().rows());
  // Only the loop and the feature's normals there are given, so the fill continues the feature.
  SurfaceFiller filler(curve, { rim }, { ComputeBoundaryNormals(feature, fans, loop) });
  const FilledSurface filled = filler.Fill({}, progress.Part(0.0, 0.6));
  std::vector<int> triangles(filled.Surface.Triangles.rows());
  std::iota(triangles.begin(), triangles.end(), 0);
  const Surface surface(filled.Surface);
  return std::move(BuildFootprintsOnSurface(
    surface, { { FindCenterOfTriangles(surface, triangles), loop, rim } }, progress.Part(0.6, 1.0))
                     .front());
}

} // namespace shape
