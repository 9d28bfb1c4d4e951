#include "CutPaste/SoupTarget.h"

#include "Base/Errors.h"
#include "CutPaste/Private/PlacedLoop.h"
#include "CutPaste/Private/SoupPatch.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

/// Moves the loop's points by 1e-7 of its mean edge: no longer does one lie on an edge of the soup.
void MoveAtRandom(Eigen::MatrixXd& loop, double edge)
{
  std::mt19937 random(1);
  for (double& coordinate : loop.reshaped())
  {
    constexpr double half = 2147483648.0; // of the generator's range
    coordinate += 1e-7 * edge * (static_cast<double>(random()) / half - 1.0);
  }
}

/// The provenance of the given points, the midpoints and the points on the loop.
Provenance TraceOrigin(const Mesh& soup, const RefinedSoup& refined, const SoupImprint& imprint,
  const std::vector<int>& pointOf, const Eigen::VectorXi& cells)
{
  ProvenanceWriter writer(soup.Points.rows());
  writer.AddCopies(soup.Points.rows());
  for (const auto& [a, b] : refined.Midpoints)
  {
    writer.AddMean({ a, b });
  }
  const Provenance before = writer.Finish(cells);
  for (const auto& mean : imprint.NewPoints)
  {
    std::vector<std::pair<int, double>> entries;
    for (const auto& [row, weight] : mean)
    {
      for (decltype(before.Weights)::InnerIterator old(before.Weights, pointOf[row]); old; ++old)
      {
        const auto same = std::find_if(entries.begin(), entries.end(),
          [&](const auto& entry) { return entry.first == old.col(); });
        if (same == entries.end())
        {
          entries.emplace_back(static_cast<int>(old.col()), weight * old.value());
        }
        else
        {
          same->second += weight * old.value();
        }
      }
    }
    writer.AddRow(entries, -1);
  }
  return writer.Finish(cells);
}

/// The uncovered triangles: those beyond the patch, and those of the patch as the loop cut them.
void CutSoup(const Mesh& soup, const RefinedSoup& refined, const SoupPatch& flat,
  const Eigen::MatrixXd& loop, double snap, LoopOnSoup& landing)
{
  const Mesh& fine = refined.Surface;
  const Eigen::MatrixXi rows = Eigen::MatrixXi(fine.Triangles(flat.Triangles, Eigen::all))
                                 .unaryExpr([&](int point) { return flat.RowOf[point]; });
  const SoupImprint imprint = ImprintLoop(flat.Images, rows, loop, snap);
  const auto before = static_cast<int>(fine.Points.rows());
  const auto given = static_cast<int>(flat.PointOf.size());
  const auto numberOf = [&](int point)
  { return point < given ? flat.PointOf[point] : before + point - given; };

  landing.Rest.Points.resize(before + static_cast<Eigen::Index>(imprint.NewPoints.size()), 3);
  landing.Rest.Points.topRows(before) = fine.Points;
  for (std::size_t i = 0; i < imprint.NewPoints.size(); ++i)
  {
    RowVector3d position = RowVector3d::Zero();
    for (const auto& [row, weight] : imprint.NewPoints[i])
    {
      position += weight * fine.Points.row(flat.PointOf[row]);
    }
    landing.Rest.Points.row(before + static_cast<Eigen::Index>(i)) = position;
  }
  std::vector<char> isInPatch(fine.Triangles.rows(), 0);
  for (const int t : flat.Triangles)
  {
    isInPatch[t] = 1;
  }
  std::vector<std::array<int, 3>> triangles;
  std::vector<int> cells, covered;
  for (int t = 0; t < static_cast<int>(isInPatch.size()); ++t)
  {
    if (!isInPatch[t])
    {
      triangles.push_back({ fine.Triangles(t, 0), fine.Triangles(t, 1), fine.Triangles(t, 2) });
      cells.push_back(refined.Original[t]);
    }
  }
  for (std::size_t t = 0; t < imprint.Original.size(); ++t)
  {
    const int original = refined.Original[flat.Triangles[imprint.Original[t]]];
    const auto row = static_cast<Eigen::Index>(t);
    if (imprint.IsCovered[t])
    {
      covered.push_back(original);
      continue;
    }
    triangles.push_back({ numberOf(imprint.Triangles(row, 0)), numberOf(imprint.Triangles(row, 1)),
      numberOf(imprint.Triangles(row, 2)) });
    cells.push_back(original);
  }
  std::sort(covered.begin(), covered.end());
  landing.Covered = static_cast<int>(std::unique(covered.begin(), covered.end()) - covered.begin());
  landing.Rest.Triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    landing.Rest.Triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1],
      triangles[t][2];
  }
  landing.Origin = TraceOrigin(soup, refined, imprint, flat.PointOf,
    Eigen::Map<const Eigen::VectorXi>(cells.data(), static_cast<Eigen::Index>(cells.size())));
  for (SeamPoint seam : imprint.Seam)
  {
    seam.Point = numberOf(seam.Point);
    landing.Seam.push_back(seam);
  }
}

/// Moves the loop's points from the sampled surface to the nearest sheet of the soup there.
void PutLoopOnSoup(LoopOnSoup& landing)
{
  const Eigen::MatrixXd sampled = landing.Positions;
  std::vector<double> nearest(sampled.rows(), std::numeric_limits<double>::infinity());
  for (const SeamPoint& seam : landing.Seam)
  {
    const RowVector3d position = landing.Rest.Points.row(seam.Point);
    const double distance = (position - sampled.row(seam.Segment)).norm();
    if (seam.Along == 0.0 && distance < nearest[seam.Segment])
    {
      nearest[seam.Segment] = distance;
      landing.Positions.row(seam.Segment) = position;
    }
  }
}

} // namespace

SoupTarget::SoupTarget(
  const shape::Surface& soup, const ExponentialMapOptions& options, const Progress& progress)
  : Options(options)
  , Locator(soup)
{
  RequireFinite(soup.Points(), "the target");
  RequireExtent(soup, "the target");
  progress(1.0);
}

// 1. Split the edges near the seed, so that the points there sample the surface (RefineSoup).
// 2. Flatten the samples by their exponential map (FlattenSoup).
// 3. Place the loop in its plane (PlaceLoop), and cut the triangles along it (CutSoup).
LoopOnSoup SoupTarget::Land(
  const FeatureFootprint& base, const PastePlacement& placement, const Progress& progress)
{
  RequireInRange(placement);
  constexpr double snapShare = 1e-3; // far above rounding, far below what can be seen
  Eigen::MatrixXd loop = PoseLoop(base, placement);
  const double edge = MeanEdgeOf(loop), extent = loop.rowwise().norm().maxCoeff();
  MoveAtRandom(loop, edge);
  const double length = std::clamp(edge, extent / 50.0, extent / 8.0);
  const double radius = 1.1 * extent + 4.0 * length;
  const RowVector3d seed = this->Locator.FindOne(placement.Seed).Position;
  const RefinedSoup refined =
    RefineSoup(this->Surface(), seed, radius, length, progress.Part(0.0, 0.3));
  const SoupPatch flat =
    FlattenSoup(refined, base, seed, radius, length, this->Options, progress.Part(0.3, 0.8));
  LoopOnSoup landing;
  landing.Seed = flat.Patch.Seed;
  PlacedLoop placed = PlaceLoop(flat.Patch, flat.Points, flat.Normals, loop, "polygons");
  landing.Positions = std::move(placed.Positions);
  landing.Normals = std::move(placed.Normals);
  CutSoup(this->Surface(), refined, flat, loop, snapShare * length, landing);
  PutLoopOnSoup(landing);
  progress(1.0);
  return landing;
}

} // namespace shape
