#include "Search/ClosestPoint.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Search/TriangleBoxes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shape
{

namespace
{

using Eigen::RowVector3d;

/// Barycentric coordinates of the point of the segment from corner i to corner j closest to p.
RowVector3d OnSegment(const Eigen::Matrix3d& corners, int i, int j, const RowVector3d& p)
{
  const RowVector3d edge = corners.row(j) - corners.row(i);
  const double length2 = edge.squaredNorm();
  const double along =
    length2 > 0.0 ? std::min(1.0, std::max(0.0, (p - corners.row(i)).dot(edge) / length2)) : 0.0;
  RowVector3d barycentric = RowVector3d::Zero();
  barycentric(i) = 1.0 - along;
  barycentric(j) += along;
  return barycentric;
}

bool IsCorner(const RowVector3d& barycentric)
{
  return barycentric.maxCoeff() == 1.0;
}

/// A triangle and data of its plane, contiguous for the search.
struct Facet
{
  Eigen::Matrix3d Corners;
  RowVector3d Normal; ///< unit; zero where there is none
};

/// The triangle closest to Position among those tested so far.
struct Nearest
{
  RowVector3d Position;
  double Bound2; ///< an upper bound of the minimum squared distance, which prunes the search
  int Triangle = -1;
  RowVector3d Barycentric = RowVector3d::Zero();

  void Look(const Facet& facet, int triangle)
  {
    // The plane is seldom closer than the best so far: most triangles are rejected here.
    const double height = (this->Position - facet.Corners.row(0)).dot(facet.Normal);
    if (height * height > this->Bound2)
    {
      return;
    }
    const RowVector3d barycentric = FindClosestPointInTriangle(facet.Corners, this->Position);
    const double distance2 = (barycentric * facet.Corners - this->Position).squaredNorm();
    if (distance2 < this->Bound2 ||
      (distance2 == this->Bound2 && IsCorner(barycentric) > IsCorner(this->Barycentric)))
    {
      this->Bound2 = distance2;
      this->Triangle = triangle;
      this->Barycentric = barycentric;
    }
  }
};

/// Searches depth first, the nearer box first. Without the queue of Eigen's search this takes a
/// third of the time. Ends as soon as the squared distance is below enough2.
void Search(
  const BoxTree& tree, const std::vector<Facet>& facets, Nearest& nearest, double enough2 = 0.0)
{
  struct Box
  {
    int Node;
    double Distance2;
  };
  std::array<Box, 128> open; // a tree halves its triangles, so one box waits per level
  int count = 0;
  open[count++] = { tree.getRootIndex(), 0.0 };
  while (count > 0)
  {
    const Box box = open[--count];
    if (nearest.Triangle >= 0 && nearest.Bound2 < enough2)
    {
      return;
    }
    if (box.Distance2 > nearest.Bound2)
    {
      continue;
    }
    BoxTree::VolumeIterator volume = nullptr, volumeEnd = nullptr;
    BoxTree::ObjectIterator object = nullptr, objectEnd = nullptr;
    tree.getChildren(box.Node, volume, volumeEnd, object, objectEnd);
    for (; object != objectEnd; ++object)
    {
      nearest.Look(facets[*object], *object);
    }
    const int first = count;
    for (; volume != volumeEnd; ++volume)
    {
      const double distance2 =
        tree.getVolume(*volume).squaredExteriorDistance(nearest.Position.transpose());
      if (distance2 <= nearest.Bound2)
      {
        open[count++] = { *volume, distance2 };
      }
    }
    if (count - first == 2 && open[first].Distance2 < open[first + 1].Distance2)
    {
      std::swap(open[first], open[first + 1]);
    }
  }
}

void RequireFound(const Nearest& nearest)
{
  if (nearest.Triangle < 0)
  {
    throw InvalidInput("a position is so far from every triangle that its distance overflows; "
                       "scale the shapes to a common size");
  }
}

} // namespace

RowVector3d FindClosestPointInTriangle(const Eigen::Matrix3d& corners, const RowVector3d& place)
{
  const RowVector3d normal = RowVector3d(corners.row(1) - corners.row(0))
                               .cross(RowVector3d(corners.row(2) - corners.row(0)));
  const double area2 = normal.squaredNorm();
  RowVector3d barycentric = RowVector3d::Zero();
  bool inside = area2 > 0.0;
  for (int k = 0; k < 3 && inside; ++k)
  {
    const RowVector3d a = corners.row((k + 1) % 3), b = corners.row((k + 2) % 3);
    barycentric(k) = (b - a).cross(place - a).dot(normal) / area2;
    inside = barycentric(k) > 0.0;
  }
  if (inside)
  {
    return barycentric / barycentric.sum();
  }
  // The projection lies outside: the closest point is on an edge.
  double best = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
  {
    const RowVector3d candidate = OnSegment(corners, k, (k + 1) % 3, place);
    const double distance2 = (candidate * corners - place).squaredNorm();
    if (distance2 < best || (distance2 == best && IsCorner(candidate) > IsCorner(barycentric)))
    {
      best = distance2;
      barycentric = candidate;
    }
  }
  return barycentric;
}

struct SurfaceLocator::Tree
{
  std::vector<Facet> Facets;
  std::shared_ptr<const BoxTree> Boxes; ///< of the triangles
};

SurfaceLocator::SurfaceLocator(const Surface& surface)
  : Searched(surface)
{
  const auto build = [&surface]()
  {
    if (surface.Triangles().rows() == 0)
    {
      throw InvalidInput("the surface to search has no triangle; give a surface with triangles");
    }
    Tree tree;
    tree.Facets.reserve(surface.Triangles().rows());
    const Eigen::MatrixXd normals = surface.AreaVectors().rowwise().normalized();
    for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
    {
      tree.Facets.push_back({ GetCorners(surface, t), normals.row(t) });
    }
    tree.Boxes = GetTriangleBoxes(surface);
    return tree;
  };
  this->Impl = surface.Cached<Tree>(build);
}

/// Searches for one position after another. Consecutive positions are usually neighbours: the
/// triangle found last gives a bound, which does not change the result.
class SurfaceLocator::Sequence
{
public:
  explicit Sequence(const Tree& tree)
    : Searched(tree)
  {
  }

  Nearest Next(const RowVector3d& position, double enough2)
  {
    constexpr double margin = 1.0 + 1e-9, maximum = std::numeric_limits<double>::max();
    Nearest nearest{ position, maximum };
    if (this->Last >= 0)
    {
      nearest.Look(this->Searched.Facets[this->Last], this->Last);
      if (nearest.Bound2 < enough2)
      {
        return nearest;
      }
      // With a margin, so that triangles at the same distance are found in the same order.
      nearest.Bound2 =
        std::max(std::min(margin * nearest.Bound2, maximum), std::numeric_limits<double>::min());
      nearest.Triangle = -1;
    }
    Search(*this->Searched.Boxes, this->Searched.Facets, nearest, enough2);
    if (nearest.Triangle < 0 && nearest.Bound2 < maximum)
    {
      // For a point on the surface, rounding can exceed the margin.
      nearest = { position, maximum };
      Search(*this->Searched.Boxes, this->Searched.Facets, nearest, enough2);
    }
    RequireFound(nearest);
    this->Last = nearest.Triangle;
    return nearest;
  }

private:
  const Tree& Searched;
  int Last = -1;
};

ClosestPoints SurfaceLocator::Find(
  const Eigen::MatrixXd& points, const Progress& progress, double enough) const
{
  const Eigen::Index n = points.rows();
  ClosestPoints result{ { Eigen::VectorXi(n), Eigen::MatrixXd(n, 3) }, Eigen::MatrixXd(n, 3),
    Eigen::VectorXd(n) };
  ParallelFor(
    static_cast<int>(n), 256,
    [&](int begin, int end)
    {
      Sequence sequence(*this->Impl);
      for (int i = begin; i < end; ++i)
      {
        const RowVector3d point = points.row(i);
        const Nearest nearest = sequence.Next(point, enough * enough);
        const RowVector3d position =
          nearest.Barycentric * this->Impl->Facets[nearest.Triangle].Corners;
        result.Triangles(i) = nearest.Triangle;
        result.Barycentrics.row(i) = nearest.Barycentric;
        result.Positions.row(i) = position;
        result.Distances(i) = (position - point).norm();
      }
    },
    progress);
  return result;
}

double SurfaceLocator::FindLargestDistance(
  const Eigen::MatrixXd& points, const Progress& progress) const
{
  constexpr int grain = 2048; // each chunk has to find a far point of its own
  const auto n = static_cast<int>(points.rows());
  std::vector<double> largest2(1 + n / grain, 0.0);
  ParallelFor(
    n, grain,
    [&](int begin, int end)
    {
      Sequence sequence(*this->Impl);
      double& own2 = largest2[begin / grain];
      for (int i = begin; i < end; ++i)
      {
        own2 = std::max(own2, sequence.Next(points.row(i), own2).Bound2);
      }
    },
    progress);
  return std::sqrt(*std::max_element(largest2.begin(), largest2.end()));
}

ClosestPoint SurfaceLocator::FindOne(const RowVector3d& point, int guess) const
{
  Nearest nearest{ point, std::numeric_limits<double>::max() };
  if (guess >= 0)
  {
    nearest.Look(this->Impl->Facets[guess], guess);
  }
  constexpr double rounding2 = 1e-28; // of the square of the coordinates
  if (guess < 0 || nearest.Bound2 > rounding2 * this->Impl->Facets[guess].Corners.squaredNorm())
  {
    Search(*this->Impl->Boxes, this->Impl->Facets, nearest);
  }
  RequireFound(nearest);
  const RowVector3d position = nearest.Barycentric * this->Impl->Facets[nearest.Triangle].Corners;
  return { { nearest.Triangle, nearest.Barycentric }, position, (position - point).norm() };
}

Mesh BuildFlatTriangles(const std::vector<Eigen::MatrixXd>& lines)
{
  Eigen::Index points = 0;
  for (const Eigen::MatrixXd& line : lines)
  {
    points += line.rows();
  }
  Mesh mesh{ Eigen::MatrixXd(points, 3),
    Eigen::MatrixXi(points - static_cast<Eigen::Index>(lines.size()), 3) };
  Eigen::Index first = 0, edge = 0;
  for (const Eigen::MatrixXd& line : lines)
  {
    mesh.Points.middleRows(first, line.rows()) = line;
    for (Eigen::Index i = 0; i + 1 < line.rows(); ++i)
    {
      const auto begin = static_cast<int>(first + i);
      mesh.Triangles.row(edge++) << begin, begin + 1, begin + 1;
    }
    first += line.rows();
  }
  return mesh;
}

} // namespace shape
