#include "CutPaste/Private/SoupPatch.h"

#include "Base/Errors.h"
#include "Geometry/SampledSurface.h"
#include "Mesh/EdgeMidpoints.h"
#include "Mesh/UsedPoints.h"
#include "Search/ClosestPoint.h"
#include "Search/PointTree.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <set>
#include <utility>

namespace shape
{

using Eigen::RowVector3d;

namespace
{

bool IsNear(const Mesh& mesh, Eigen::Index triangle, const RowVector3d& seed, double radius)
{
  const Eigen::Matrix3d corners = mesh.Points(mesh.Triangles.row(triangle), Eigen::all);
  const RowVector3d closest = FindClosestPointInTriangle(corners, seed) * corners;
  return (closest - seed).norm() <= radius;
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

/// Chooses the samples among points of a soup: of sheets that nearly coincide, one is sampled.
class SheetThinning
{
public:
  /// triangles: those of the soup that are sampled. given: their points, ascending.
  SheetThinning(const Mesh& soup, const Eigen::MatrixXi& triangles, const std::vector<int>& given)
    : Points(soup.Points(given, Eigen::all))
    , Triangles(RenumberPoints(triangles, given, soup.Points.rows()))
    , Fans(this->Triangles, this->Points.rows())
    , Tree(this->Points)
    , IsKept(given.size(), 0)
  {
  }

  /// Returns the indices of the points that are kept. A point is left out if an earlier one within
  /// `distance` is on another sheet: no path of edges within this distance connects them.
  std::vector<int> Run(double distance)
  {
    std::vector<int> kept;
    for (int i = 0; i < static_cast<int>(this->IsKept.size()); ++i)
    {
      const std::vector<int> near = this->Tree.Within(this->Points.row(i), distance);
      const std::set<int> sheet = this->SheetOf(i, near);
      if (std::all_of(near.begin(), near.end(),
            [&](int other) { return this->IsKept[other] == 0 || sheet.count(other) > 0; }))
      {
        this->IsKept[i] = 1;
        kept.push_back(i);
      }
    }
    return kept;
  }

private:
  /// Returns the near points that edges between near points connect with a point. near: ascending.
  std::set<int> SheetOf(int point, const std::vector<int>& near) const
  {
    std::set<int> sheet{ point };
    std::vector<int> left{ point };
    while (!left.empty())
    {
      const int next = left.back();
      left.pop_back();
      for (int i = this->Fans.First[next]; i < this->Fans.First[next + 1]; ++i)
      {
        for (const int corner : this->Triangles.row(this->Fans.Triangles[i]))
        {
          if (std::binary_search(near.begin(), near.end(), corner) && sheet.insert(corner).second)
          {
            left.push_back(corner);
          }
        }
      }
    }
    return sheet;
  }

  Eigen::MatrixXd Points;
  Eigen::MatrixXi Triangles;
  TriangleFans Fans;
  PointTree Tree;
  std::vector<char> IsKept;
};

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

} // namespace

RefinedSoup RefineSoup(
  const Mesh& soup, const RowVector3d& seed, double radius, double length, const Progress& progress)
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

SoupPatch FlattenSoup(const RefinedSoup& refined, const FeatureFootprint& base,
  const RowVector3d& seed, double radius, double length, const ExponentialMapOptions& options,
  const Progress& progress)
{
  // relative to the length of split edges: sheets closer than the first are sampled once, and
  // points closer to a sampled sheet than the second belong to it
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
  std::vector<int> kept =
    SheetThinning(soup, soup.Triangles(near, Eigen::all), used).Run(thin * length);
  for (int& sample : kept)
  {
    sample = used[sample];
  }
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

} // namespace shape
