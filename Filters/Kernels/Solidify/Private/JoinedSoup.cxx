#include "Solidify/Private/JoinedSoup.h"

#include "Geometry/SurfaceWelding.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace shape
{

JoinedSoup JoinSoup(const Mesh& soup, double tolerance, const Progress& progress)
{
  RequireIndices(soup);
  JoinedSoup joined;
  const Eigen::Index count = soup.Points.rows();
  std::vector<char> isFinite(count);
  for (int point = 0; point < static_cast<int>(count); ++point)
  {
    isFinite[point] = soup.Points.row(point).allFinite();
    if (!isFinite[point])
    {
      joined.NotFinite.push_back(point);
    }
  }
  std::vector<int> finite;
  for (int t = 0; t < static_cast<int>(soup.Triangles.rows()); ++t)
  {
    const Eigen::RowVector3i corners = soup.Triangles.row(t);
    if (isFinite[corners(0)] && isFinite[corners(1)] && isFinite[corners(2)])
    {
      finite.push_back(t);
    }
  }
  // Points that no triangle uses must not affect the size, to which the tolerance is relative.
  const std::vector<int> used = FindUsedPoints(soup.Triangles(finite, Eigen::all), count);
  const Eigen::MatrixXd positions = soup.Points(used, Eigen::all);
  RequireExtent(positions, "the surface");
  const std::vector<int> first = tolerance > 0.0
    ? FindPointsWithinDistance(positions, tolerance, progress)
    : FindPointsWithinTolerance(positions, progress);
  std::vector<int> firstOf(count, -1);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    firstOf[used[i]] = used[first[i]];
    if (used[first[i]] != used[i])
    {
      joined.Joined.push_back(used[i]);
    }
  }
  joined.Surface = { soup.Points, Eigen::MatrixXi(static_cast<Eigen::Index>(finite.size()), 3) };
  for (const int t : finite)
  {
    const Eigen::RowVector3i corners =
      soup.Triangles.row(t).unaryExpr([&](int point) { return firstOf[point]; });
    if (corners(0) == corners(1) || corners(1) == corners(2) || corners(2) == corners(0))
    {
      joined.Collapsed.push_back(t);
      continue;
    }
    joined.Surface.Triangles.row(static_cast<Eigen::Index>(joined.Triangles.size())) = corners;
    joined.Triangles.push_back(t);
  }
  joined.Surface.Triangles.conservativeResize(
    static_cast<Eigen::Index>(joined.Triangles.size()), 3);
  for (int point = 0; point < static_cast<int>(count); ++point)
  {
    if (isFinite[point] && firstOf[point] < 0)
    {
      joined.Loose.push_back(point);
    }
    if (firstOf[point] < 0)
    {
      joined.Surface.Points.row(point).setZero(); // used by no triangle
    }
  }
  return joined;
}

std::vector<int> FindSameTriangles(const Eigen::MatrixXi& triangles)
{
  const auto cornersOf = [&](int t)
  {
    std::array<int, 3> corners = { triangles(t, 0), triangles(t, 1), triangles(t, 2) };
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::vector<int> order(triangles.rows()), first(triangles.rows());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return cornersOf(a) < cornersOf(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    first[order[i]] =
      i > 0 && cornersOf(order[i - 1]) == cornersOf(order[i]) ? first[order[i - 1]] : order[i];
  }
  return first;
}

} // namespace shape
