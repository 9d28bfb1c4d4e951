#include "ExponentialMap/PatchLayout.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/Extent.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"
#include "Parameterize/FlipRepair.h"
#include "Planar/PlanarLocator.h"
#include "Quality/MapQuality.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector2d;

int Mend(const Surface& surface, ExponentialPatch& patch, const Progress& progress)
{
  const int mended =
    RepairFlips(BuildPatchSurface(surface, patch), patch.Positions, patch.Torn, progress);
  const auto isMended = [&](int row)
  {
    return EvaluateOrientation(patch.Positions.row(patch.Corners(row, 0)),
             patch.Positions.row(patch.Corners(row, 1)),
             patch.Positions.row(patch.Corners(row, 2))) > 0;
  };
  patch.Flipped.erase(
    std::remove_if(patch.Flipped.begin(), patch.Flipped.end(), isMended), patch.Flipped.end());
  return mended;
}

/// Marks the triangles that are neither flipped nor torn.
Eigen::VectorXi FindSoundTriangles(const ExponentialPatch& patch)
{
  Eigen::VectorXi sound = Eigen::VectorXi::Ones(patch.Corners.rows());
  for (const auto* rows : { &patch.Flipped, &patch.Torn })
  {
    for (const int row : *rows)
    {
      sound(row) = 0;
    }
  }
  return sound;
}

/// Returns the weighted quantiles of values (t); 0 if there are none.
DistortionStatistics ComputeQuantiles(const Eigen::VectorXd& values, const Eigen::VectorXd& weights)
{
  std::vector<int> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return values(a) < values(b); });
  const double sum = weights.sum();
  DistortionStatistics spread;
  double done = 0.0;
  for (const int i : order)
  {
    spread.Median = done < 0.5 * sum ? values(i) : spread.Median;
    spread.Percentile95 = done < 0.95 * sum ? values(i) : spread.Percentile95;
    done += weights(i);
  }
  return spread;
}

} // namespace

PatchLayout FlattenPatch(ExponentialMap& map, const Eigen::RowVector3d& seed,
  const Eigen::RowVector3d& xDirection, const PatchLayoutOptions& options, const Progress& progress)
{
  RequireFinite(seed, "the Seed");
  RequireFinite(xDirection, "the XDirection");
  RequireOption(std::isfinite(options.Radius) && options.Radius >= 0.0, "Radius", options.Radius,
    "positive, or 0 for a tenth of the diagonal");
  constexpr double share = 0.1;
  PatchLayout layout;
  const double diagonal = ComputeBoxDiagonal(map.Surface());
  // A circle of a smaller radius has no area in double precision.
  constexpr double minimum = 1e-9;
  RequireOption(options.Radius == 0.0 || options.Radius >= minimum * diagonal, "Radius",
    options.Radius, "0, or at least 1e-09 of the diagonal of the surface");
  layout.Radius = options.Radius > 0.0 ? options.Radius : share * diagonal;
  const ClosestPoint position = map.Locator().FindOne(seed);
  layout.SeedDistance = position.Distance;
  layout.Patch =
    map.Around(position, layout.Radius, xDirection, progress.Part(0.0, 0.4, "spreading the patch"));
  if (layout.Patch.Points.empty())
  {
    throw InvalidInput("no point of the surface lies within Radius (" +
      std::to_string(layout.Radius) + ") of the Seed; raise Radius, or refine the surface there");
  }
  layout.Provenance = TraceCopies(layout.Patch.Points, map.Surface().Points().rows(),
    Eigen::Map<const Eigen::VectorXi>(layout.Patch.Triangles.data(), layout.Patch.Corners.rows()));
  if (options.MendFlips)
  {
    if (layout.Patch.Shares.size() > 0)
    {
      throw InvalidInput("MendFlips needs a surface of triangles, and these are points; turn it "
                         "off, or connect the points with a surface reconstruction first");
    }
    layout.Mended =
      Mend(map.Surface(), layout.Patch, progress.Part(0.4, 0.8, "unfolding the patch"));
  }
  layout.Facts =
    ComputeExponentialFacts(map.Surface(), layout.Patch, layout.Radius, progress.Part(0.8, 1.0));
  return layout;
}

Mesh BuildPatchSurface(const Surface& surface, const ExponentialPatch& patch)
{
  return { surface.Points()(patch.Points, Eigen::all), patch.Corners };
}

/// Two overlapping parts of a disk-like image have a boundary: one of its edges runs through the
/// other part.
bool IsOverlappingItself(const ExponentialPatch& patch)
{
  std::vector<char> torn(patch.Corners.rows(), 0);
  for (const int row : patch.Torn)
  {
    torn[row] = 1;
  }
  std::vector<int> whole;
  for (int row = 0; row < patch.Corners.rows(); ++row)
  {
    if (!torn[row])
    {
      whole.push_back(row);
    }
  }
  const PlanarLocator locator(patch.Positions, patch.Corners, patch.Torn);
  const std::vector<HalfEdge> sides =
    SortHalfEdges(patch.Corners(whole, Eigen::all), patch.Positions.rows());
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    const HalfEdge& side = sides[begin];
    while (end < sides.size() && sides[end].Low() == side.Low() && sides[end].High() == side.High())
    {
      ++end;
    }
    if (end > begin + 1)
    {
      continue;
    }
    const RowVector2d a = patch.Positions.row(side.Begin), b = patch.Positions.row(side.End);
    const auto runsThrough = [&](int row)
    { return SegmentMeetsTriangle(a, b, patch.Positions(patch.Corners.row(row), Eigen::all)); };
    if (locator.AnyNear(a.cwiseMin(b), a.cwiseMax(b), runsThrough))
    {
      return true;
    }
  }
  return false;
}

bool AreSamplesOverlapping(const Surface& surface, const ExponentialPatch& patch)
{
  const auto count = static_cast<int>(patch.Points.size());
  const Eigen::VectorXi sound = FindSoundTriangles(patch);
  Eigen::VectorXd longest = Eigen::VectorXd::Zero(count);
  const auto distance = [&](int i, int j) {
    return (surface.Points().row(patch.Points[i]) - surface.Points().row(patch.Points[j])).norm();
  };
  for (Eigen::Index row = 0; row < patch.Corners.rows(); ++row)
  {
    for (int k = 0; k < 3 && sound(row) != 0; ++k)
    {
      const int i = patch.Corners(row, k), j = patch.Corners(row, (k + 1) % 3);
      longest(i) = std::max(longest(i), distance(i, j));
      longest(j) = std::max(longest(j), distance(i, j));
    }
  }
  Eigen::MatrixXd images = Eigen::MatrixXd::Zero(count, 3);
  images.leftCols(2) = patch.Positions;
  const PointTree tree(images);
  for (int i = 0; i < count; ++i)
  {
    for (const int j : tree.Within(images.row(i), 0.5 * longest(i)))
    {
      if (distance(i, j) > 2.0 * longest(i))
      {
        return true;
      }
    }
  }
  return false;
}

ExponentialFacts ComputeExponentialFacts(
  const Surface& surface, const ExponentialPatch& patch, double radius, const Progress& progress)
{
  ExponentialFacts facts;
  const auto count = static_cast<double>(patch.Corners.rows());
  facts.FlipRate = count > 0.0 ? static_cast<double>(patch.Flipped.size()) / count : 0.0;
  CellSimplices cells;
  for (const auto& corners : patch.Corners.rowwise())
  {
    const std::array<int, 3> points = { corners(0), corners(1), corners(2) };
    cells.Add(CellShape::Triangle, points.data());
    cells.EndCell();
  }
  const Eigen::MatrixXd points = surface.Points()(patch.Points, Eigen::all);
  Eigen::MatrixXd images = Eigen::MatrixXd::Zero(patch.Positions.rows(), 3);
  images.leftCols(2) = patch.Positions;
  const MapQualityResult quality = EvaluateMapQuality(
    points, images, cells, ComputeMapExtent(points, images, cells), progress.Part(0.0, 0.8));
  facts.ConformalDistortions =
    quality.Measures.col(static_cast<int>(MapMeasure::ConformalDistortion));
  facts.SymmetricDirichlets =
    quality.Measures.col(static_cast<int>(MapMeasure::SymmetricDirichlet));

  const bool isSampled = patch.Shares.size() > 0;
  const Eigen::VectorXi sound = FindSoundTriangles(patch);
  Eigen::VectorXd shares = sound.cast<double>();
  if (isSampled)
  {
    shares = shares.cwiseProduct(patch.Shares).eval();
  }
  const Eigen::VectorXd areas = quality.Sizes.cwiseProduct(shares);
  facts.ConformalDistortion = ComputeQuantiles(facts.ConformalDistortions, areas);
  facts.SymmetricDirichlet = ComputeQuantiles(facts.SymmetricDirichlets, areas);
  double area = 0.0;
  for (Eigen::Index row = 0; row < patch.Corners.rows(); ++row)
  {
    const RowVector2d a = patch.Positions.row(patch.Corners(row, 0));
    const RowVector2d u = patch.Positions.row(patch.Corners(row, 1)) - a,
                      v = patch.Positions.row(patch.Corners(row, 2)) - a;
    // Positive, since sound triangles are counter-clockwise.
    area += shares(row) * 0.5 * (u(0) * v(1) - u(1) * v(0));
  }
  facts.Coverage = area / (M_PI * radius * radius);
  facts.Overlaps = isSampled ? AreSamplesOverlapping(surface, patch) : IsOverlappingItself(patch);
  progress(1.0);
  return facts;
}

} // namespace shape
