#include "Hex/Polycube/Private/WorkingSolid.h"

#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Remesh/IsotropicRemesh.h"
#include "Tetrahedra/Tetrahedralize.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr int Attempts = 4;
/// The factor by which edges become shorter if the remeshed surface crosses itself.
constexpr double LengthShrinkage = 0.7;

/// Returns the volume of a regular tetrahedron.
double RegularVolume(double edge)
{
  return edge * edge * edge / (6.0 * std::sqrt(2.0));
}

Surface CoarseSurface(const Surface& surface, double length, const Progress& progress)
{
  // Triangles become smaller while the remeshed surface crosses itself; if that does not end, the
  // surface itself is taken.
  for (int attempt = 0; attempt < Attempts; ++attempt, length *= LengthShrinkage)
  {
    IsotropicRemeshOptions options;
    options.EdgeLength = length;
    const Surface coarse = RemeshIsotropically(surface, options, progress);
    if (FindDegenerateTriangles(coarse).empty() && FindSelfIntersections(coarse, progress).empty())
    {
      return coarse;
    }
  }
  return surface;
}

using Simplices = std::vector<std::vector<int>>;

/// The simplices of a mesh, indexed by their points, which can be split at edges.
class EdgeSplits
{
public:
  EdgeSplits(const Eigen::MatrixXi& simplices, Eigen::Index points)
    : Around(points)
  {
    for (const auto& simplex : simplices.rowwise())
    {
      this->Add({ simplex.begin(), simplex.end() });
    }
  }

  /// Splits each simplex that contains both ends into two, with `middle` in place of one end each.
  void Split(int a, int b, int middle)
  {
    this->Around.resize(std::max<std::size_t>(this->Around.size(), middle + 1));
    // A copy: Add changes the list.
    const std::vector<int> around = this->Around[a];
    for (const int i : around)
    {
      std::vector<int>& first = this->All[i];
      const auto at = std::find(first.begin(), first.end(), b);
      if (at != first.end())
      {
        std::vector<int> second = first;
        *at = middle;
        std::replace(second.begin(), second.end(), a, middle);
        std::vector<int>& ofB = this->Around[b];
        ofB.erase(std::find(ofB.begin(), ofB.end(), i));
        this->Around[middle].push_back(i);
        this->Add(std::move(second));
        if (!this->Marks.empty())
        {
          this->Marks.push_back(this->Marks[i]);
        }
      }
    }
  }

  /// Inserts a point into simplex i.
  void Fill(int i, int middle)
  {
    this->Around.resize(std::max<std::size_t>(this->Around.size(), middle + 1));
    const std::vector<int> corners = this->All[i];
    for (std::size_t k = 1; k < corners.size(); ++k)
    {
      std::vector<int> part = corners;
      part[k] = middle;
      this->Add(std::move(part));
    }
    this->All[i][0] = middle;
    std::vector<int>& around = this->Around[corners[0]];
    around.erase(std::find(around.begin(), around.end(), i));
    this->Around[middle].push_back(i);
  }

  Eigen::MatrixXi Result() const
  {
    Eigen::MatrixXi result(this->All.size(), this->All.front().size());
    for (std::size_t i = 0; i < this->All.size(); ++i)
    {
      result.row(i) = Eigen::Map<const Eigen::RowVectorXi>(
        this->All[i].data(), static_cast<Eigen::Index>(this->All[i].size()));
    }
    return result;
  }

  Simplices All;
  std::vector<int> Marks; ///< of the simplices, or empty; parts inherit the mark

private:
  void Add(std::vector<int> simplex)
  {
    for (const int point : simplex)
    {
      this->Around[point].push_back(static_cast<int>(this->All.size()));
    }
    this->All.push_back(std::move(simplex));
  }

  std::vector<std::vector<int>> Around;
};

void AppendMean(Eigen::MatrixXd& points, const std::vector<int>& of)
{
  Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(points.cols());
  for (const int point : of)
  {
    mean += points.row(point) / static_cast<double>(of.size());
  }
  points.conservativeResize(points.rows() + 1, Eigen::NoChange);
  points.bottomRows<1>() = mean;
}

/// Returns the edges of triangles or tetrahedra without repeats, in ascending order.
std::vector<std::pair<int, int>> EdgesOf(const Eigen::MatrixXi& simplices)
{
  std::vector<std::pair<int, int>> edges;
  for (const auto& simplex : simplices.rowwise())
  {
    for (const int a : simplex)
    {
      for (const int b : simplex)
      {
        if (a < b)
        {
          edges.emplace_back(a, b);
        }
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Inserts a point into every inner edge and every tetrahedron whose points are all on the
/// boundary. Otherwise flattening the boundary could make such an edge or tetrahedron degenerate,
/// whatever its inner points do.
void AddInnerPoints(WorkingSolid& solid)
{
  const std::vector<std::pair<int, int>> outer = EdgesOf(solid.Triangles);
  EdgeSplits splits(solid.Tetrahedra, solid.Points.rows());
  for (const auto& [a, b] : EdgesOf(solid.Tetrahedra))
  {
    if (std::max(a, b) < solid.SurfacePointCount &&
      !std::binary_search(outer.begin(), outer.end(), std::make_pair(a, b)))
    {
      splits.Split(a, b, static_cast<int>(solid.Points.rows()));
      AppendMean(solid.Points, { a, b });
    }
  }
  const std::size_t count = splits.All.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::vector<int> corners = splits.All[i];
    if (*std::max_element(corners.begin(), corners.end()) < solid.SurfacePointCount)
    {
      splits.Fill(static_cast<int>(i), static_cast<int>(solid.Points.rows()));
      AppendMean(solid.Points, corners);
    }
  }
  solid.Tetrahedra = splits.Result();
}

} // namespace

Mesh WorkingSolid::Surface() const
{
  return this->Surface(this->Points);
}

Mesh WorkingSolid::Surface(const Eigen::MatrixXd& points) const
{
  return { points.topRows(this->SurfacePointCount), this->Triangles };
}

WorkingSolid BuildWorkingSolid(const Surface& surface, int triangles, const Progress& progress)
{
  const double area = ComputeArea(surface);
  // The area of an equilateral triangle is sqrt(3) / 4 of its edge squared.
  const double length = std::sqrt(area / triangles * 4.0 / std::sqrt(3.0));
  const Surface coarse = CoarseSurface(surface, length, progress.Part(0.0, 0.5));
  TetrahedralizeOptions options;
  // Inner tetrahedra may be larger than those at the surface: only the surface is labelled.
  options.MaximumVolume = 10.0 * RegularVolume(length);
  const TetrahedralizeResult tetrahedra =
    Tetrahedralize(coarse, {}, options, progress.Part(0.5, 0.9));
  WorkingSolid solid;
  solid.Points = tetrahedra.Points;
  solid.Tetrahedra = tetrahedra.Tetrahedra;
  solid.Triangles = coarse.Triangles();
  solid.SurfacePointCount = static_cast<int>(coarse.Points().rows());
  AddInnerPoints(solid);
  return solid;
}

void SplitSurfaceEdges(WorkingSolid& solid, const std::vector<std::pair<int, int>>& edges,
  Eigen::MatrixXd& positions, Eigen::VectorXi& labels)
{
  const int before = solid.SurfacePointCount, more = static_cast<int>(edges.size());
  // The new points follow the surface's points.
  const auto moved = [&](int point) { return point < before ? point : point + more; };
  for (Eigen::MatrixXd* all : { &solid.Points, &positions })
  {
    Eigen::MatrixXd wider(all->rows() + more, 3);
    wider.topRows(before) = all->topRows(before);
    wider.bottomRows(all->rows() - before) = all->bottomRows(all->rows() - before);
    for (int i = 0; i < more; ++i)
    {
      wider.row(before + i) = 0.5 * (all->row(edges[i].first) + all->row(edges[i].second));
    }
    *all = wider;
  }
  EdgeSplits tetrahedra(solid.Tetrahedra.unaryExpr(moved), solid.Points.rows());
  EdgeSplits triangles(solid.Triangles, solid.Points.rows());
  triangles.Marks.assign(labels.begin(), labels.end());
  for (int i = 0; i < more; ++i)
  {
    tetrahedra.Split(edges[i].first, edges[i].second, before + i);
    triangles.Split(edges[i].first, edges[i].second, before + i);
  }
  solid.Tetrahedra = tetrahedra.Result();
  solid.Triangles = triangles.Result();
  labels = Eigen::Map<const Eigen::VectorXi>(
    triangles.Marks.data(), static_cast<Eigen::Index>(triangles.Marks.size()));
  solid.SurfacePointCount += more;
}

} // namespace shape
