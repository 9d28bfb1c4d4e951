#include "CutPaste/CutFeature.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "CutPaste/FootprintLayout.h"
#include "Geodesics/SurfacePath.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"
#include "Remesh/CurveImprinting.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// Adds the fills to the rest.
void Append(const FilledSurface& filled, DividedPart& rest)
{
  const Eigen::Index given = rest.Surface.Triangles.rows();
  const Eigen::Index triangles = filled.Surface.Triangles.rows();
  rest.Surface.Points = filled.Surface.Points;
  rest.Surface.Triangles.conservativeResize(triangles, 3);
  rest.Surface.Triangles.bottomRows(triangles - given) =
    filled.Surface.Triangles.bottomRows(triangles - given);
  rest.Provenance = Compose(rest.Provenance, filled.Provenance);
  rest.Ids.resize(filled.Surface.Points.rows(), -1);
}

/// Returns, for each point of a loop of the feature, the coincident point of the rest. Of duplicate
/// points on a seam, `loop` keeps one.
std::vector<int> PointsAt(
  std::vector<int>& loop, const DividedPart& feature, const DividedPart& rest)
{
  std::map<int, int> pointOf;
  for (int i = 0; i < static_cast<int>(rest.Ids.size()); ++i)
  {
    pointOf.insert({ rest.Ids[i], i });
  }
  std::vector<int> points, kept;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const int id = feature.Ids[loop[i]];
    if (id != feature.Ids[loop[(i + loop.size() - 1) % loop.size()]])
    {
      kept.push_back(loop[i]);
      points.push_back(pointOf.at(id));
    }
  }
  loop = std::move(kept);
  return points;
}

/// The feature's bases at the loops whose holes in the rest were filled.
/// Section 4.2 of the paper: the loop is embedded in the parameterization of the fill region, and
/// the initial frames are taken from this surface. Of several fills, a base is on the one that
/// shares most points with its loop.
void FindBases(const Surface& filled, const std::vector<std::vector<int>>& loops,
  CutFeatureResult& result, const Progress& progress)
{
  std::vector<FilledLoop> ofHoles;
  for (std::vector<int> loop : loops)
  {
    std::vector<int> on = PointsAt(loop, result.Feature, result.Rest);
    const std::set<int> isOn(on.begin(), on.end());
    const FilledHole* best = nullptr;
    int maximum = 0;
    for (const FilledHole& hole : result.Holes)
    {
      const auto shared = static_cast<int>(std::count_if(
        hole.Loop.begin(), hole.Loop.end(), [&](int point) { return isOn.count(point) > 0; }));
      if (shared > maximum)
      {
        maximum = shared;
        best = &hole;
      }
    }
    if (best)
    {
      std::vector<int> triangles(best->Triangles);
      std::iota(triangles.begin(), triangles.end(), best->FirstTriangle);
      ofHoles.push_back(
        { FindCenterOfTriangles(filled, triangles), std::move(loop), std::move(on) });
    }
  }
  result.Bases = BuildFootprintsOnSurface(filled, ofHoles, progress);
}

/// Fills the holes that a feature leaves. Even if the loop has many short edges, the number of
/// triangles is limited to about that of triangles as large as the surface's.
FilledSurface Filled(const Surface& rest, const std::vector<std::vector<int>>& loops,
  double meanArea, FillHolesOptions options, const Progress& progress)
{
  double enough = 0.0;
  for (const std::vector<int>& loop : loops)
  {
    Eigen::RowVector3d area = Eigen::RowVector3d::Zero();
    const Eigen::RowVector3d first = rest.Points().row(loop.front());
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    {
      const Eigen::RowVector3d here = rest.Points().row(loop[i]),
                               next = rest.Points().row(loop[i + 1]);
      area += 0.5 * (here - first).cross(next - first);
    }
    // A triangulation has about half as many inner points as triangles. The area is that of the
    // loop, projected along its area vector.
    enough = std::max(enough, 0.5 * area.norm() / meanArea + static_cast<double>(loop.size()));
  }
  int& maximum = options.Filler.MaximumPoints;
  maximum = enough < maximum ? static_cast<int>(enough) : maximum;
  return FillLoops(rest, loops, options, progress);
}

/// Replaces points of the holes' loops by their duplicates, from `first` on, if the fills use
/// these.
void RenumberLoops(const DividedPart& part, std::size_t first, std::vector<FilledHole>& holes)
{
  for (FilledHole& hole : holes)
  {
    const auto corners =
      part.Surface.Triangles.middleRows(hole.FirstTriangle, hole.Triangles).reshaped();
    std::map<int, int> copies; // by the point of the surface
    for (const int corner : corners)
    {
      if (corner >= static_cast<int>(first))
      {
        copies[part.Ids[corner]] = corner;
      }
    }
    for (int& point : hole.Loop)
    {
      const auto copy = copies.find(part.Ids[point]);
      point = copy == copies.end() ? point : copy->second;
    }
  }
}

/// Returns the points of a part with the ids of loops.
std::vector<std::vector<int>> PointsWith(
  const std::vector<std::vector<int>>& loops, const std::vector<int>& ids)
{
  std::map<int, int> pointOf;
  for (int i = 0; i < static_cast<int>(ids.size()); ++i)
  {
    pointOf.insert({ ids[i], i });
  }
  std::vector<std::vector<int>> points;
  for (const std::vector<int>& loop : loops)
  {
    points.emplace_back();
    std::transform(loop.begin(), loop.end(), std::back_inserter(points.back()),
      [&](int id) { return pointOf.at(id); });
  }
  return points;
}

std::vector<std::vector<int>> Reversed(std::vector<std::vector<int>> loops)
{
  for (std::vector<int>& loop : loops)
  {
    std::reverse(loop.begin(), loop.end());
  }
  return loops;
}

/// Builds the parts of a divided surface, and fills the rest. across: the loops as ids, with the
/// feature to the left, if they cross gaps, and are therefore no boundary loops.
/// Section 4.2 of the paper, "cut": both parts are built, the hole of the rest is filled, and the
/// feature's loop is embedded in the fill. Pinches of the rest are parted after the fill, which may
/// use their points.
void Divide(const SurfaceDivision& division, const std::vector<std::vector<int>>& across,
  const CutFeatureOptions& options, CutFeatureResult& result, const Progress& progress)
{
  result.CutLength = division.CutLength();
  result.Feature = division.PartOf(true);
  division.PartPinches(result.Feature);
  const std::vector<std::vector<int>> loops = across.empty()
    ? division.CutLoops(result.Feature.Surface, result.Feature.Ids)
    : PointsWith(across, result.Feature.Ids);
  result.Loops = static_cast<int>(loops.size());
  result.Rest = division.PartOf(false);
  progress(0.1);
  if (options.FillHole)
  {
    const Surface whole(MergeSeam(result.Rest));
    const std::vector<std::vector<int>> holes = across.empty()
      ? division.CutLoops(whole, result.Rest.Ids)
      : Reversed(PointsWith(across, result.Rest.Ids));
    FilledSurface filled = Filled(whole, holes, division.MeanArea(), options.Fill,
      progress.Part(0.1, 0.6, "filling the holes"));
    Append(filled, result.Rest);
    result.Holes = std::move(filled.Holes);
    FindBases(filled.Surface, loops, result, progress.Part(0.6, 1.0, "finding the base"));
  }
  const std::size_t points = result.Rest.Ids.size();
  division.PartPinches(result.Rest);
  RenumberLoops(result.Rest, points, result.Holes);
  progress(1.0);
}

} // namespace

FeatureCutter::FeatureCutter(const shape::Surface& surface, const Progress& progress)
  : Surface(surface)
  , Joined(this->Surface, progress)
{
  const std::vector<int> used(this->Joined.Surface.Triangles.reshaped().begin(),
    this->Joined.Surface.Triangles.reshaped().end());
  RequireExtent(this->Surface.Points()(used, Eigen::all), "the surface");
}

FeatureCutter::~FeatureCutter() = default;

struct FeatureCutter::Traced
{
  explicit Traced(const shape::Surface& surface)
    : Locator(surface)
    , Paths(this->Locator.GetSurface())
  {
    const std::vector<int>& twins = this->Paths.Twins();
    DisjointSets parts(static_cast<int>(twins.size() / 3));
    for (int side = 0; side < static_cast<int>(twins.size()); ++side)
    {
      if (twins[side] >= 0)
      {
        parts.Merge(side / 3, twins[side] / 3);
      }
    }
    for (int triangle = 0; triangle < static_cast<int>(twins.size() / 3); ++triangle)
    {
      this->PartOf.push_back(parts.Find(triangle));
    }
  }

  /// Returns the first position of a closed curve that no path connects with the next one, or -1.
  int FindGap(const Eigen::MatrixXd& curve) const
  {
    const Eigen::VectorXi triangles = this->Locator.Find(curve).Triangles;
    for (int i = 0; i < static_cast<int>(triangles.size()); ++i)
    {
      if (this->PartOf[triangles(i)] != this->PartOf[triangles((i + 1) % triangles.size())])
      {
        return i;
      }
    }
    return -1;
  }

  SurfaceLocator Locator;
  SurfacePaths Paths;
  std::vector<int> PartOf; ///< the part of each triangle; paths do not leave it
};

std::vector<Eigen::MatrixXd> FeatureCutter::Chosen(
  const std::vector<Eigen::MatrixXd>& curves, const CutFeatureOptions& options) const
{
  const int index = options.LoopIndex;
  const auto count = static_cast<int>(curves.size());
  if (count == 0)
  {
    throw InvalidInput("there is no loop; draw a closed curve on the surface");
  }
  if (index < -1 || index >= count)
  {
    throw InvalidInput("Loop Index is " + std::to_string(index) + ", but the number of loops is " +
      std::to_string(count) + "; loops are numbered from 0, and -1 takes all");
  }
  std::vector<Eigen::MatrixXd> chosen = curves;
  if (index >= 0)
  {
    chosen = { curves[index] };
  }
  for (const Eigen::MatrixXd& curve : chosen)
  {
    RequireFinite(curve, "the loop");
  }
  return chosen;
}

FeatureCutter::Traced& FeatureCutter::SurfaceUnder(
  const std::vector<Eigen::MatrixXd>& curves, const Progress& progress)
{
  // Cutting along a selection needs none.
  if (!this->Plain)
  {
    this->Plain = std::make_unique<Traced>(this->Joined.Surface);
  }
  const auto isWhole = [](const Traced& traced, const Eigen::MatrixXd& curve)
  { return traced.FindGap(curve) < 0; };
  if (std::all_of(curves.begin(), curves.end(),
        [&](const Eigen::MatrixXd& curve) { return isWhole(*this->Plain, curve); }))
  {
    return *this->Plain;
  }
  const double width = ComputeMeanEdgeLength(this->Joined.Surface);
  if (!this->Bridged)
  {
    Mesh bridged = this->Joined.Surface;
    const Eigen::MatrixXi bridges = FindGapBridges(bridged, width, progress);
    const Eigen::Index given = bridged.Triangles.rows();
    bridged.Triangles.conservativeResize(given + bridges.rows(), 3);
    bridged.Triangles.bottomRows(bridges.rows()) = bridges;
    this->Bridged = std::make_unique<Traced>(bridged);
  }
  for (const Eigen::MatrixXd& curve : curves)
  {
    const int gap = this->Bridged->FindGap(curve);
    if (gap >= 0)
    {
      std::ostringstream words;
      words
        << "points " << gap << " and " << (gap + 1) % curve.rows()
        << " of the loop are on parts of the surface that are not connected, and the gaps "
           "between them are wider than the mean edge, "
        << width
        << ", or their triangles are not oriented alike; draw the loop on one part, orient the "
           "triangles with Generate Surface Normals (Consistency), or join the parts with Shape "
           "Solidify";
      throw InvalidInput(words.str());
    }
  }
  return *this->Bridged;
}

// 1. Trace the curves on the surface, as shortest paths or along creases (TraceLoopThrough). If
//    they cross gaps, bridge these first (SurfaceUnder).
// 2. Insert them as edges (ImprintCurves).
// 3. Choose the side of the loops that is the feature (MarkTrianglesOnSide).
// 4. Divide the surface there, and fill the hole (Divide).
CutFeatureResult FeatureCutter::Cut(const std::vector<Eigen::MatrixXd>& curves,
  const CutFeatureOptions& options, const Progress& progress)
{
  progress(0.0);
  const std::vector<Eigen::MatrixXd> chosenCurves = this->Chosen(curves, options);
  Traced& traced = this->SurfaceUnder(chosenCurves, progress.Part(0.0, 0.05));
  const Progress tracing = progress.Part(0.05, 0.2, "connecting the loop on the surface");
  std::vector<SurfaceLoop> loops;
  const auto count = static_cast<double>(chosenCurves.size());
  for (const Eigen::MatrixXd& curve : chosenCurves)
  {
    const auto done = static_cast<double>(loops.size());
    loops.push_back(TraceLoopThrough(curve, traced.Locator, traced.Paths, options.Path,
      tracing.Part(done / count, (done + 1.0) / count)));
  }
  ImprintedCurves split = ImprintCurves(traced.Locator.GetSurface(), loops, { options.SnapShare },
    progress.Part(0.2, 0.3, "cutting the surface"));
  // Only the longest part of a curve that touches itself is used.
  std::vector<std::vector<int>> chosen;
  std::vector<char> isTaken(loops.size(), 0);
  for (std::size_t i = 0; i < split.Loops.size(); ++i)
  {
    char& taken = isTaken[split.LoopIds[i]];
    if (taken == 0)
    {
      chosen.push_back(split.Loops[i]);
      taken = 1;
    }
  }
  CutFeatureResult result;
  result.WeldedPoints = this->Joined.WeldedPoints;
  result.LoopsLeftOut = static_cast<int>(split.Loops.size() - chosen.size());
  std::vector<char> isFeature = MarkTrianglesOnSide(split.Surface, chosen, options.Side);
  std::vector<std::vector<int>> across;
  if (&traced == this->Bridged.get())
  {
    across = std::move(chosen);
    result.Gaps = RemoveGapBridges(
      static_cast<int>(this->Joined.Surface.Triangles.rows()), split, isFeature, across);
  }
  const SurfaceDivision division(
    this->Surface, this->Joined, std::move(split), std::move(isFeature));
  Divide(division, across, options, result, progress.Part(0.3, 1.0));
  return result;
}

CutFeatureResult FeatureCutter::Cut(const std::vector<char>& isSelected,
  const CutFeatureOptions& options, const Progress& progress) const
{
  progress(0.0);
  ImprintedCurves split;
  split.Surface = this->Joined.Surface;
  split.Provenance =
    TraceIdentity(this->Joined.Surface.Points.rows(), this->Joined.Surface.Triangles.rows());
  std::vector<char> isFeature;
  for (const int triangle : this->Joined.Triangles)
  {
    isFeature.push_back(isSelected.at(triangle));
  }
  if (std::none_of(isFeature.begin(), isFeature.end(), [](char own) { return own != 0; }))
  {
    throw InvalidInput("the selection has no cell of the surface; select cells of it");
  }
  const SurfaceDivision division(
    this->Surface, this->Joined, std::move(split), std::move(isFeature));
  if (division.CutLength() == 0.0)
  {
    throw InvalidInput("the selection has no edge in common with the rest of the surface: there is"
                       " nothing to cut; select a part of a component, or use Extract Selection");
  }
  CutFeatureResult result;
  result.WeldedPoints = this->Joined.WeldedPoints;
  Divide(division, {}, options, result, progress);
  return result;
}

CutFeatureResult CutFeature(const Surface& surface, const std::vector<Eigen::MatrixXd>& curves,
  const CutFeatureOptions& options, const Progress& progress)
{
  return FeatureCutter(surface, progress.Part(0.0, 0.1))
    .Cut(curves, options, progress.Part(0.1, 1.0));
}

CutFeatureResult CutFeature(const Surface& surface, const std::vector<char>& isSelected,
  const CutFeatureOptions& options, const Progress& progress)
{
  return FeatureCutter(surface, progress.Part(0.0, 0.1))
    .Cut(isSelected, options, progress.Part(0.1, 1.0));
}

} // namespace shape
