#include "CutPaste/SoupTarget.h"

#include "Base/Errors.h"
#include "Geometry/SampledSurface.h"
#include "Mesh/EdgeMidpoints.h"
#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"
#include "Planar/PlanarLocator.h"
#include "Search/PointTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

/// The soup with split edges near the seed.
struct RefinedSoup
{
  Mesh Surface;
  std::vector<int> Original;                 ///< for each triangle, the given one
  std::vector<std::array<int, 2>> Midpoints; ///< for each new point, the ends of its edge
};

bool IsNear(const Mesh& mesh, Eigen::Index triangle, const RowVector3d& seed, double radius)
{
  const Eigen::Matrix3d corners = mesh.Points(mesh.Triangles.row(triangle), Eigen::all);
  const RowVector3d closest = FindClosestPointInTriangle(corners, seed) * corners;
  return (closest - seed).norm() <= radius;
}

/// Splits edges of near triangles in two, until none is longer than `length`.
RefinedSoup Refine(const Mesh& soup, const RowVector3d& seed, double radius, double length,
  const Progress& progress)
{
  RefinedSoup refined{ soup, {}, {} };
  for (int t = 0; t < static_cast<int>(soup.Triangles.rows()); ++t)
  {
    refined.Original.push_back(t);
  }
  while (true)
  {
    progress(0.0);
    std::vector<std::array<int, 2>> edges;
    const Mesh& mesh = refined.Surface;
    for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const auto [a, b] = std::minmax({ mesh.Triangles(t, k), mesh.Triangles(t, (k + 1) % 3) });
        if ((mesh.Points.row(a) - mesh.Points.row(b)).norm() > length &&
          IsNear(mesh, t, seed, radius))
        {
          edges.push_back({ a, b });
        }
      }
    }
    if (edges.empty())
    {
      return refined;
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const Eigen::Index points = mesh.Points.rows();
    CutTriangles cut = SplitEdges(mesh.Triangles, edges, static_cast<int>(points));
    refined.Surface.Points.conservativeResize(
      points + static_cast<Eigen::Index>(cut.Midpoints.size()), 3);
    for (std::size_t i = 0; i < cut.Midpoints.size(); ++i)
    {
      const auto [a, b] = cut.Midpoints[i];
      refined.Surface.Points.row(points + static_cast<Eigen::Index>(i)) =
        0.5 * (refined.Surface.Points.row(a) + refined.Surface.Points.row(b));
      refined.Midpoints.push_back(cut.Midpoints[i]);
    }
    for (int& original : cut.Original)
    {
      original = refined.Original[original];
    }
    refined.Surface.Triangles = std::move(cut.Triangles);
    refined.Original = std::move(cut.Original);
  }
}

/// Turns the samples to the side on which most of the triangles are counter-clockwise, by area.
/// near: the triangles. rowOf: the sample at each point, or -1.
void ChooseSide(const Mesh& soup, const std::vector<int>& near, const std::vector<int>& rowOf,
  SampledSurface& samples)
{
  double sum = 0.0;
  for (const int t : near)
  {
    const Eigen::RowVector3i corners = soup.Triangles.row(t);
    const RowVector3d a = soup.Points.row(corners(0));
    const RowVector3d u = soup.Points.row(corners(1)) - a, v = soup.Points.row(corners(2)) - a;
    const RowVector3d area = u.cross(v);
    for (const int corner : corners)
    {
      sum += rowOf[corner] < 0 ? 0.0 : area.dot(samples.Normals.row(rowOf[corner]));
    }
  }
  if (sum < 0.0)
  {
    samples.Normals *= -1.0;
    samples.Surface.Triangles.col(1).swap(samples.Surface.Triangles.col(2));
  }
}

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

double MeanEdgeOf(const Eigen::MatrixXd& loop)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
  {
    sum += (loop.row((i + 1) % loop.rows()) - loop.row(i)).norm();
  }
  return sum / static_cast<double>(loop.rows());
}

/// The patch of the samples, and the part of the refined soup that it maps to the plane.
struct SoupPatch
{
  ExponentialPatch Patch;
  Eigen::MatrixXd Points, Normals; ///< of the samples in the patch, in its order
  std::vector<int> PointOf;        ///< k points of the refined soup: first the samples
  Eigen::MatrixXd Images;          ///< k x 2
  std::vector<int> RowOf;          ///< for each point of the refined soup, its row, or -1
  std::vector<int> Triangles;      ///< of the refined soup, with all corners in the patch
};

/// Returns those of the given points that are not within `distance` of an earlier one. Sheets that
/// nearly coincide are sampled once.
std::vector<int> Thin(
  const Eigen::MatrixXd& points, const std::vector<int>& given, double distance)
{
  const PointTree tree(points(given, Eigen::all));
  std::vector<char> isKept(given.size(), 0);
  std::vector<int> kept;
  for (std::size_t i = 0; i < given.size(); ++i)
  {
    const std::vector<int> near = tree.Within(points.row(given[i]), distance);
    if (std::none_of(near.begin(), near.end(), [&](int other) { return isKept[other] != 0; }))
    {
      isKept[i] = 1;
      kept.push_back(given[i]);
    }
  }
  return kept;
}

/// Gives points that are no samples the image of the nearest place on the local triangles.
void AddImages(const Mesh& soup, const std::vector<int>& points, double distance, SoupPatch& flat)
{
  const auto samples = static_cast<Eigen::Index>(flat.Patch.Points.size());
  std::vector<int> others;
  for (const int point : points)
  {
    if (flat.RowOf[point] < 0)
    {
      others.push_back(point);
    }
  }
  flat.Images.resize(samples + static_cast<Eigen::Index>(others.size()), 2);
  flat.Images.topRows(samples) = flat.Patch.Positions;
  if (!others.empty())
  {
    const SurfaceLocator locator{ Surface(flat.Points, flat.Patch.Corners) };
    const ClosestPoints closest = locator.Find(soup.Points(others, Eigen::all));
    const Eigen::MatrixXd images = PullBack(closest, flat.Patch.Corners, flat.Patch.Positions);
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      const auto row = static_cast<Eigen::Index>(i);
      if (closest.Distances(row) <= distance)
      {
        const auto next = static_cast<int>(flat.PointOf.size());
        flat.RowOf[others[i]] = next;
        flat.Images.row(next) = images.row(row);
        flat.PointOf.push_back(others[i]);
      }
    }
  }
  flat.Images.conservativeResize(static_cast<Eigen::Index>(flat.PointOf.size()), 2);
}

SoupPatch Flatten(const RefinedSoup& refined, const FeatureFootprint& base, const RowVector3d& seed,
  double radius, double length, const ExponentialMapOptions& options, const Progress& progress)
{
  // relative to the length of split edges: sheets closer than the first are sampled once, and points
  // closer to a sampled sheet than the second belong to it
  constexpr double thin = 0.25, same = 0.5;
  const Mesh& soup = refined.Surface;
  std::vector<int> near;
  for (int t = 0; t < static_cast<int>(soup.Triangles.rows()); ++t)
  {
    if (IsNear(soup, t, seed, radius))
    {
      near.push_back(t);
    }
  }
  const Eigen::Index all = soup.Points.rows();
  const std::vector<int> used = FindUsedPoints(soup.Triangles(near, Eigen::all), all);
  const std::vector<int> kept = Thin(soup.Points, used, thin * length);
  SampledSurface samples =
    ConnectSamples(soup.Points(kept, Eigen::all), {}, {}, progress.Part(0.0, 0.7));
  ChooseSide(soup, near, InvertIndices(kept, all), samples);
  ExponentialMap map(samples, options, progress.Part(0.7, 0.9));
  const ClosestPoint position = map.Locator().FindOne(seed);
  SoupPatch flat;
  flat.Patch =
    map.Around(position, radius, TurnAxis(base, map.Normal(position)), progress.Part(0.9, 1.0));
  if (flat.Patch.Triangles.empty())
  {
    throw InvalidInput("there are no polygons around the seed, or the gaps between them are too "
                       "wide; raise Scale or move Seed");
  }
  for (const int sample : flat.Patch.Points)
  {
    flat.PointOf.push_back(kept[sample]);
  }
  flat.RowOf = InvertIndices(flat.PointOf, all);
  flat.Points = samples.Surface.Points(flat.Patch.Points, Eigen::all);
  flat.Normals = samples.Normals(flat.Patch.Points, Eigen::all);
  AddImages(soup, used, same * length, flat);
  for (const int t : near)
  {
    const Eigen::RowVector3i corners = soup.Triangles.row(t);
    if (std::all_of(
          corners.begin(), corners.end(), [&](int corner) { return flat.RowOf[corner] >= 0; }))
    {
      flat.Triangles.push_back(t);
    }
  }
  return flat;
}

/// Positions and normals of the loop's points on the sampled surface.
void PlaceLoop(const SoupPatch& flat, const Eigen::MatrixXd& loop, LoopOnSoup& landing)
{
  const PlanarLocator locator(flat.Patch.Positions, flat.Patch.Corners, flat.Patch.Torn);
  landing.Positions.resize(loop.rows(), 3);
  landing.Normals.resize(loop.rows(), 3);
  int beyond = 0;
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
  {
    const SurfacePoint at = locator.Find(loop.row(i));
    if (at.Triangle < 0)
    {
      ++beyond;
      continue;
    }
    const Eigen::RowVector3i corners = flat.Patch.Corners.row(at.Triangle);
    landing.Positions.row(i) = at.Barycentric * flat.Points(corners, Eigen::all);
    landing.Normals.row(i) = (at.Barycentric * flat.Normals(corners, Eigen::all)).normalized();
  }
  if (beyond > 0)
  {
    throw InvalidInput("the feature does not fit at the seed: " + std::to_string(beyond) + " of the " +
      std::to_string(loop.rows()) + " points of its loop would lie beyond the polygons there, or in a "
      "gap that is too wide; lower Scale or move Seed");
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
  const Eigen::MatrixXd& loop, LoopOnSoup& landing)
{
  const Mesh& fine = refined.Surface;
  const Eigen::MatrixXi rows = Eigen::MatrixXi(fine.Triangles(flat.Triangles, Eigen::all))
                                 .unaryExpr([&](int point) { return flat.RowOf[point]; });
  const SoupImprint imprint = ImprintLoop(flat.Images, rows, loop);
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
  landing.Covered =
    static_cast<int>(std::unique(covered.begin(), covered.end()) - covered.begin());
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
  progress(1.0);
}

// 1. Split the edges near the seed, so that the points there sample the surface (Refine).
// 2. Flatten the samples by their exponential map (Flatten).
// 3. Place the loop in its plane (PlaceLoop), and cut the triangles along it (CutSoup).
LoopOnSoup SoupTarget::Land(
  const FeatureFootprint& base, const PastePlacement& placement, const Progress& progress)
{
  RequireOption(
    placement.Scale > 0.0 && std::isfinite(placement.Scale), "Scale", placement.Scale, "positive");
  RequireOption(std::isfinite(placement.Rotation), "Rotation", placement.Rotation, "finite");
  RequireFinite(placement.Seed, "Seed");
  const Eigen::Rotation2Dd turn(placement.Rotation * M_PI / 180.0);
  Eigen::MatrixXd loop = placement.Scale * base.LoopPositions * turn.toRotationMatrix().transpose();
  const double edge = MeanEdgeOf(loop), extent = loop.rowwise().norm().maxCoeff();
  MoveAtRandom(loop, edge);
  const double length = std::clamp(edge, extent / 50.0, extent / 8.0);
  const double radius = 1.1 * extent + 4.0 * length;
  const RowVector3d seed = this->Locator.FindOne(placement.Seed).Position;
  const RefinedSoup refined =
    Refine(this->Surface(), seed, radius, length, progress.Part(0.0, 0.3));
  const SoupPatch flat =
    Flatten(refined, base, seed, radius, length, this->Options, progress.Part(0.3, 0.8));
  LoopOnSoup landing;
  landing.Seed = flat.Patch.Seed;
  PlaceLoop(flat, loop, landing);
  CutSoup(this->Surface(), refined, flat, loop, landing);
  PutLoopOnSoup(landing);
  progress(1.0);
  return landing;
}

} // namespace shape
