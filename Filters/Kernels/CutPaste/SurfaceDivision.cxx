#include "CutPaste/SurfaceDivision.h"

#include "Base/DisjointSets.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/UsedPoints.h"

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
        beside.insert(this->Split.Provenance.Cells(t));
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
  return this->Joined.Triangles[this->Split.Provenance.Cells(triangle)];
}

/// The given point of a triangle that corresponds to a welded one.
int SurfaceDivision::GivenPoint(int triangle, int point) const
{
  const Eigen::RowVector3i joined =
    this->Joined.Surface.Triangles.row(this->Split.Provenance.Cells(triangle));
  const auto k = std::find(joined.begin(), joined.end(), point) - joined.begin();
  return this->Surface.Triangles()(this->OriginalOf(triangle), k);
}

/// The barycentric coordinates of a new point in the given triangle that a triangle is a part of.
Eigen::RowVector3d SurfaceDivision::WeightsOf(int triangle, int point) const
{
  const int joined = this->Split.Provenance.Cells(triangle);
  Eigen::RowVector3d weights;
  for (int k = 0; k < 3; ++k)
  {
    weights(k) =
      this->Split.Provenance.Weights.coeff(point, this->Joined.Surface.Triangles(joined, k));
  }
  return weights;
}

DividedPart SurfaceDivision::PartOf(bool feature) const
{
  const auto given = static_cast<int>(this->Surface.Points().rows());
  DividedPart part;
  std::vector<Eigen::RowVector3i> triangles; // indices of the given points, then of the added ones
  // On a seam, a new point is duplicated as the given points are, since both sides have their own
  // data.
  struct AddedPoint
  {
    int Id;
    Eigen::RowVector3i Corners; ///< given points
    Eigen::RowVector3d Weights;
  };
  std::map<std::array<int, 4>, int> numberOfAdded; // by the point and the given ones around it
  std::vector<AddedPoint> added;
  const auto add = [&](int triangle, int point)
  {
    const Eigen::RowVector3i corners = this->Surface.Triangles().row(this->OriginalOf(triangle));
    const Eigen::RowVector3d weights = this->WeightsOf(triangle, point);
    // The given edge that contains the point distinguishes the two sides of a seam.
    std::array<int, 4> key{ -1, -1, -1, point };
    std::transform(corners.begin(), corners.end(), weights.begin(), key.begin(),
      [](int corner, double weight) { return weight > 0.0 ? corner : -1; });
    std::sort(key.begin(), key.begin() + 3);
    const auto [found, isNew] =
      numberOfAdded.insert({ key, given + static_cast<int>(added.size()) });
    if (isNew)
    {
      added.push_back({ point, corners, weights });
    }
    return found->second;
  };
  std::vector<int> cells;
  for (int t = 0; t < static_cast<int>(this->IsFeature.size()); ++t)
  {
    if ((this->IsFeature[t] != 0) == feature)
    {
      cells.push_back(this->OriginalOf(t));
      triangles.emplace_back();
      for (int k = 0; k < 3; ++k)
      {
        const int point = this->Split.Surface.Triangles(t, k);
        triangles.back()(k) = point < given ? this->GivenPoint(t, point) : add(t, point);
      }
    }
  }
  Eigen::MatrixXi& corners = part.Surface.Triangles;
  corners.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    corners.row(static_cast<Eigen::Index>(t)) = triangles[t];
  }
  const Eigen::Index all = given + static_cast<Eigen::Index>(added.size());
  const std::vector<int> points = FindUsedPoints(corners, all);
  corners = RenumberPoints(corners, points, all);
  ProvenanceWriter provenance(given);
  for (const int point : points)
  {
    if (point < given)
    {
      part.Ids.push_back(this->Joined.First[point]);
      provenance.AddCopy(point);
    }
    else
    {
      const AddedPoint& own = added[point - given];
      part.Ids.push_back(own.Id);
      provenance.AddOnTriangle(own.Corners, own.Weights);
    }
  }
  part.Surface.Points = this->Split.Surface.Points(part.Ids, Eigen::all);
  part.Provenance = provenance.Finish(
    Eigen::Map<const Eigen::VectorXi>(cells.data(), static_cast<Eigen::Index>(cells.size())));
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
  const auto triangles = static_cast<int>(mesh.Triangles.rows());
  part.Provenance = Compose(part.Provenance,
    TraceCopies(all, points, Eigen::VectorXi::LinSpaced(triangles, 0, triangles - 1)));
  for (std::size_t i = points; i < all.size(); ++i)
  {
    part.Ids.push_back(part.Ids[all[i]]);
  }
}

} // namespace shape
