#include "Geometry/SurfaceWelding.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <array>
#include <utility>

namespace shape
{
namespace
{

bool HasPointTwice(const Eigen::RowVector3i& triangle)
{
  return triangle(0) == triangle(1) || triangle(1) == triangle(2) || triangle(2) == triangle(0);
}

/// Returns, for each point, the first of those that are welded to it.
std::vector<int> FirstOfEach(const Mesh& surface, const std::vector<int>& placeOf)
{
  const auto points = static_cast<int>(placeOf.size());
  DisjointSets same(points);
  Eigen::MatrixXi sound(surface.Triangles.rows(), 3);
  Eigen::Index count = 0;
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    if (!HasPointTwice(surface.Triangles.row(t)))
    {
      sound.row(count++) = surface.Triangles.row(t);
    }
  }
  sound.conservativeResize(count, 3);
  const std::vector<HalfEdge> sides = SortHalfEdges(sound, points);
  // Edges without length are contracted. Boundary edges are collected with the positions of their
  // ends in ascending order, so that the two edges of a seam are adjacent after sorting.
  std::vector<std::pair<std::array<int, 2>, std::array<int, 2>>> alone; // positions, points
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    while (end < sides.size() && sides[end].Low() == sides[begin].Low() &&
      sides[end].High() == sides[begin].High())
    {
      ++end;
    }
    std::array<int, 2> ends{ sides[begin].Low(), sides[begin].High() };
    if (placeOf[ends[0]] == placeOf[ends[1]])
    {
      same.Merge(ends[0], ends[1]);
    }
    else if (end - begin == 1)
    {
      if (placeOf[ends[0]] > placeOf[ends[1]])
      {
        std::swap(ends[0], ends[1]);
      }
      alone.push_back({ { placeOf[ends[0]], placeOf[ends[1]] }, ends });
    }
  }
  std::sort(alone.begin(), alone.end());
  for (std::size_t i = 1; i < alone.size(); ++i)
  {
    // Two boundary edges between the same positions: their ends are welded in pairs.
    if (alone[i].first == alone[i - 1].first)
    {
      same.Merge(alone[i].second[0], alone[i - 1].second[0]);
      same.Merge(alone[i].second[1], alone[i - 1].second[1]);
    }
  }
  std::vector<int> first(points), lowest(points, -1);
  for (int point = 0; point < points; ++point)
  {
    int& low = lowest[same.Find(point)];
    low = low < 0 ? point : low;
    first[point] = low;
  }
  return first;
}

/// Returns the points, with unused ones moved to the position of a used one, so that they affect
/// neither the size nor anything else.
Eigen::MatrixXd WithUnusedAside(const Mesh& surface)
{
  std::vector<bool> isUsed(surface.Points.rows(), false);
  for (const int corner : surface.Triangles.reshaped())
  {
    isUsed[corner] = true;
  }
  Eigen::MatrixXd positions = surface.Points;
  for (Eigen::Index point = 0; point < positions.rows(); ++point)
  {
    if (!isUsed[point])
    {
      positions.row(point) = surface.Points.row(surface.Triangles(0, 0));
    }
  }
  return positions;
}

/// Points moved and scaled to size 1, so that squares of distances neither overflow nor vanish.
struct NormalizedPoints
{
  Eigen::MatrixXd Positions;
  double Unit = 1.0; ///< the length that became 1
};

NormalizedPoints Normalize(const Eigen::MatrixXd& points)
{
  const double size = ComputeLongestBoxEdge(points);
  const double unit = size > 0.0 ? size : 1.0;
  return { points.rows() == 0 ? points : (points.rowwise() - points.row(0)) / unit, unit };
}

/// Returns, for each position, the first one within this distance of it.
std::vector<int> FirstWithin(
  const Eigen::MatrixXd& positions, double distance, const Progress& progress)
{
  const auto count = static_cast<int>(positions.rows());
  std::vector<int> first(count, -1);
  if (count == 0)
  {
    return first;
  }
  const PointTree tree(positions);
  for (int i = 0; i < count; ++i)
  {
    if (i % 65536 == 0)
    {
      progress(static_cast<double>(i) / count);
    }
    if (first[i] < 0)
    {
      for (const int j : tree.Within(positions.row(i), distance))
      {
        first[j] = first[j] < 0 ? i : first[j];
      }
      first[i] = i;
    }
  }
  return first;
}

} // namespace

std::vector<int> FindPointsWithinTolerance(const Eigen::MatrixXd& points, const Progress& progress)
{
  const Eigen::MatrixXd positions = Normalize(points).Positions;
  return FirstWithin(positions, WeldTolerance * ComputeBoxDiagonal(positions), progress);
}

std::vector<int> FindPointsWithinDistance(
  const Eigen::MatrixXd& points, double distance, const Progress& progress)
{
  const NormalizedPoints normalized = Normalize(points);
  return FirstWithin(normalized.Positions, distance / normalized.Unit, progress);
}

WeldedSurface::WeldedSurface(const Mesh& surface, const Progress& progress, const std::string& name)
  : Surface(surface)
{
  if (surface.Triangles.rows() == 0)
  {
    throw InvalidInput(name + " has no triangles; give a surface");
  }
  if (surface.Triangles.minCoeff() < 0 || surface.Triangles.maxCoeff() >= surface.Points.rows())
  {
    throw InvalidInput("a triangle of " + name +
      " uses a point that does not exist; recreate the surface, or apply Clean to it");
  }
  const Eigen::MatrixXd positions = WithUnusedAside(surface);
  RequireFinite(positions, name);
  RequireExtent(surface, name);
  this->First = FirstOfEach(surface, FindPointsWithinTolerance(positions, progress));
  for (int t = 0; t < static_cast<int>(surface.Triangles.rows()); ++t)
  {
    const Eigen::RowVector3i at =
      surface.Triangles.row(t).unaryExpr([&](int point) { return this->First[point]; });
    if (!HasPointTwice(at))
    {
      this->Surface.Triangles.row(static_cast<Eigen::Index>(this->Triangles.size())) = at;
      this->Triangles.push_back(t);
    }
  }
  this->Surface.Triangles.conservativeResize(static_cast<Eigen::Index>(this->Triangles.size()), 3);
  if (this->Triangles.empty())
  {
    throw InvalidInput("no triangle of " + name + " has three different points; give a surface");
  }
  for (int point = 0; point < static_cast<int>(this->First.size()); ++point)
  {
    this->WeldedPoints += this->First[point] != point ? 1 : 0;
  }
}

} // namespace shape
