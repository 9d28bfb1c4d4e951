#include "CutPaste/SurfaceDivision.h"

#include "Base/DisjointSets.h"
#include "Geodesics/TriangleStrip.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/HalfEdges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

namespace shape
{

Mesh MergeSeam(const DividedPart& part)
{
  Mesh whole = part.Surface;
  std::map<int, int> first; // by id
  for (int point = 0; point < static_cast<int>(part.Ids.size()); ++point)
  {
    first.insert({ part.Ids[point], point });
  }
  for (int& point : whole.Triangles.reshaped())
  {
    point = part.Ids[point] < 0 ? point : first.at(part.Ids[point]);
  }
  return whole;
}

SurfaceDivision::SurfaceDivision(const shape::Surface& surface, const WeldedSurface& joined,
  ImprintedCurves split, std::vector<char> isFeature)
  : Surface(surface)
  , Joined(joined)
  , Split(std::move(split))
  , IsFeature(std::move(isFeature))
{
  const Mesh& mesh = this->Split.Surface;
  const std::vector<HalfEdge> edges = SortHalfEdges(mesh.Triangles, mesh.Points.rows());
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
  {
    const HalfEdge &one = edges[i], &other = edges[i + 1];
    // At an edge with more than two triangles, consecutive ones are compared; an edge is inserted
    // once.
    if (one.Low() == other.Low() && one.High() == other.High() &&
      this->IsFeature[one.Triangle] != this->IsFeature[other.Triangle] &&
      this->Cut.insert({ one.Low(), one.High() }).second)
    {
      this->CutPoints.insert({ one.Low(), one.High() });
      this->Length += (mesh.Points.row(one.Low()) - mesh.Points.row(one.High())).norm();
    }
  }
}

/// Of the triangles as given: those that the cut has split are smaller.
double SurfaceDivision::MeanArea() const
{
  std::set<int> beside;
  for (int t = 0; t < static_cast<int>(this->IsFeature.size()); ++t)
  {
    const Eigen::RowVector3i corners = this->Split.Surface.Triangles.row(t);
    for (int k = 0; k < 3; ++k)
    {
      if (this->Cut.count(std::minmax(corners(k), corners((k + 1) % 3))) > 0)
      {
        beside.insert(this->Split.OriginalTriangles(t));
      }
    }
  }
  double area = 0.0;
  for (const int triangle : beside)
  {
    const Eigen::Matrix3d corners = GetCorners(this->Joined.Surface, triangle);
    area += 0.5 * (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).norm();
  }
  return beside.empty() ? 0.0 : area / static_cast<double>(beside.size());
}

int SurfaceDivision::OriginalOf(int triangle) const
{
  return this->Joined.Triangles[this->Split.OriginalTriangles(triangle)];
}

/// The given point of a triangle that corresponds to a welded one.
int SurfaceDivision::GivenPoint(int triangle, int point) const
{
  const Eigen::RowVector3i joined =
    this->Joined.Surface.Triangles.row(this->Split.OriginalTriangles(triangle));
  const auto k = std::find(joined.begin(), joined.end(), point) - joined.begin();
  return this->Surface.Triangles()(this->OriginalOf(triangle), k);
}

/// The position of a new point in a given triangle that contains it.
SurfacePoint SurfaceDivision::NewPosition(int triangle, int point) const
{
  const SurfacePoints& added = this->Split.NewPoints;
  const Eigen::Index row = point - this->Surface.Points().rows();
  const PointSupport support(
    this->Joined.Surface, { added.Triangles(row), added.Barycentrics.row(row) });
  const int joined = this->Split.OriginalTriangles(triangle);
  return { this->OriginalOf(triangle), support.In(this->Joined.Surface, joined).Barycentric };
}

DividedPart SurfaceDivision::PartOf(bool feature) const
{
  const auto given = static_cast<int>(this->Surface.Points().rows());
  DividedPart part;
  std::vector<Eigen::RowVector3i> triangles; // indices of the given points, then of the added ones
  // On a seam, a new point is duplicated as the given points are, since both sides have their own
  // data.
  std::map<std::array<int, 3>, int> numberOfAdded;
  std::vector<std::pair<int, SurfacePoint>> added;
  const auto add = [&](int triangle, int point)
  {
    const SurfacePoint position = this->NewPosition(triangle, point);
    const PointSupport support(this->Surface, position);
    const auto [low, high] = std::minmax(support.Points[0], support.Points[1]);
    // The given edge that contains the point distinguishes the two sides of a seam.
    const auto [found, isNew] =
      numberOfAdded.insert({ { point, low, high }, given + static_cast<int>(added.size()) });
    if (isNew)
    {
      added.emplace_back(point, position);
    }
    return found->second;
  };
  for (int t = 0; t < static_cast<int>(this->IsFeature.size()); ++t)
  {
    if ((this->IsFeature[t] != 0) == feature)
    {
      part.OriginalTriangles.push_back(this->OriginalOf(t));
      triangles.emplace_back();
      for (int k = 0; k < 3; ++k)
      {
        const int point = this->Split.Surface.Triangles(t, k);
        triangles.back()(k) = point < given ? this->GivenPoint(t, point) : add(t, point);
      }
    }
  }
  // The first triangle of each point.
  std::vector<int> firsts(given + added.size(), -1), numbers(firsts.size(), -1), points;
  for (int t = static_cast<int>(triangles.size()) - 1; t >= 0; --t)
  {
    for (const int point : triangles[t])
    {
      firsts[point] = part.OriginalTriangles[t];
    }
  }
  for (int point = 0; point < static_cast<int>(firsts.size()); ++point)
  {
    if (firsts[point] >= 0)
    {
      numbers[point] = static_cast<int>(points.size());
      points.push_back(point);
    }
  }
  const auto count = static_cast<Eigen::Index>(points.size());
  part.Surface.Points.resize(count, 3);
  part.Positions = { Eigen::VectorXi(count), Eigen::MatrixXd(count, 3) };
  for (Eigen::Index row = 0; row < count; ++row)
  {
    const int point = points[row], triangle = firsts[point];
    const bool isGiven = point < given;
    const int id = isGiven ? this->Joined.First[point] : added[point - given].first;
    part.OriginalPoints.push_back(isGiven ? point : -1);
    part.Ids.push_back(id);
    part.Surface.Points.row(row) = this->Split.Surface.Points.row(id);
    part.Positions.Triangles(row) = isGiven ? triangle : added[point - given].second.Triangle;
    part.Positions.Barycentrics.row(row) = isGiven
      ? Eigen::RowVector3d(
          (this->Surface.Triangles().row(triangle).array() == point).cast<double>())
      : added[point - given].second.Barycentric;
  }
  part.Surface.Triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    part.Surface.Triangles.row(static_cast<Eigen::Index>(t)) =
      triangles[t].unaryExpr([&](int point) { return numbers[point]; });
  }
  return part;
}

std::vector<std::vector<int>> SurfaceDivision::CutLoops(
  const Mesh& part, const std::vector<int>& ids) const
{
  // A part's boundary consists of cut edges and of the boundary that the surface already had.
  std::vector<std::vector<int>> loops = FindBoundaryLoops(part).Loops;
  const auto isOfOldBoundary = [&](const std::vector<int>& loop)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const int a = ids[loop[i]], b = ids[loop[(i + 1) % loop.size()]];
      if (a != b && this->Cut.count(std::minmax(a, b)) == 0) // the same point: a seam
      {
        return true;
      }
    }
    return false;
  };
  loops.erase(std::remove_if(loops.begin(), loops.end(), isOfOldBoundary), loops.end());
  return loops;
}

void SurfaceDivision::PartPinches(DividedPart& part) const
{
  Mesh& mesh = part.Surface;
  // Corners at one point are connected if their triangles share an edge.
  DisjointSets fans(static_cast<int>(mesh.Triangles.size()));
  const Eigen::MatrixXi whole = MergeSeam(part).Triangles;
  const std::vector<HalfEdge> edges = SortHalfEdges(whole, mesh.Points.rows());
  const auto cornerOf = [&](int triangle, int point)
  {
    const auto row = whole.row(triangle);
    return 3 * triangle + (row(0) == point ? 0 : row(1) == point ? 1 : 2);
  };
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
  {
    const HalfEdge &one = edges[i], &other = edges[i + 1];
    if (one.Low() == other.Low() && one.High() == other.High())
    {
      for (const int point : { one.Low(), one.High() })
      {
        fans.Merge(cornerOf(one.Triangle, point), cornerOf(other.Triangle, point));
      }
    }
  }
  const auto points = static_cast<int>(mesh.Points.rows());
  std::vector<int> firstFans(points, -1), all(points);
  std::map<std::pair<int, int>, int> copies; // by fan and point
  std::iota(all.begin(), all.end(), 0);
  for (int corner = 0; corner < static_cast<int>(mesh.Triangles.size()); ++corner)
  {
    const int point = mesh.Triangles(corner / 3, corner % 3), fan = fans.Find(corner);
    firstFans[point] = firstFans[point] < 0 ? fan : firstFans[point];
    // The first fan keeps the point. Pinches of the given surface, away from the cut, stay.
    if (firstFans[point] != fan && this->CutPoints.count(part.Ids[point]) > 0)
    {
      const auto [copy, isNew] = copies.insert({ { fan, point }, static_cast<int>(all.size()) });
      if (isNew)
      {
        all.push_back(point);
      }
      mesh.Triangles(corner / 3, corner % 3) = copy->second;
    }
  }
  mesh.Points = mesh.Points(all, Eigen::all).eval();
  part.Positions.Triangles = part.Positions.Triangles(all).eval();
  part.Positions.Barycentrics = part.Positions.Barycentrics(all, Eigen::all).eval();
  for (std::size_t i = points; i < all.size(); ++i)
  {
    part.OriginalPoints.push_back(part.OriginalPoints[all[i]]);
    part.Ids.push_back(part.Ids[all[i]]);
  }
}

} // namespace shape
