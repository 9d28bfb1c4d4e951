#include "Transfer/TextureSeams.h"

#include "Mesh/HalfEdges.h"
#include "Search/ClosestPoint.h"
#include "Search/TriangleWalk.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>

namespace shape
{
namespace
{

/// Whether each corner of a triangle is opposite an edge on the boundary: m x 3.
Eigen::MatrixXi FindBoundaryEdges(const Surface& surface)
{
  const std::vector<int>& twins = surface.Twins();
  Eigen::MatrixXi isOpposite(surface.Triangles().rows(), 3);
  for (Eigen::Index t = 0; t < isOpposite.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k) // the half-edge k runs from corner k to the next one
    {
      isOpposite(t, (k + 2) % 3) = twins[3 * t + k] < 0 ? 1 : 0;
    }
  }
  return isOpposite;
}

} // namespace

bool HasSeams(const Surface& surface)
{
  const Eigen::MatrixXi isOpposite = FindBoundaryEdges(surface);
  std::vector<int> points;
  for (Eigen::Index t = 0; t < isOpposite.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (isOpposite(t, k) == 1)
      {
        points.push_back(surface.Triangles()(t, (k + 1) % 3));
        points.push_back(surface.Triangles()(t, (k + 2) % 3));
      }
    }
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto at = [&](int point)
  {
    const auto row = surface.Points().row(point);
    return std::array<double, 3>{ row(0), row(1), row(2) };
  };
  std::vector<std::array<double, 3>> positions(points.size());
  std::transform(points.begin(), points.end(), positions.begin(), at);
  std::sort(positions.begin(), positions.end());
  return std::adjacent_find(positions.begin(), positions.end()) != positions.end();
}

SplitPolygons SplitAtSeams(const Surface& giver, const Eigen::MatrixXd& texture,
  const std::vector<std::vector<int>>& polygons, const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& found, const Progress& progress)
{
  SplitPolygons split{ polygons, {}, found };
  Eigen::MatrixXd centroids(static_cast<Eigen::Index>(polygons.size()), 3);
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    centroids.row(static_cast<Eigen::Index>(i)) =
      positions(polygons[i], Eigen::all).colwise().mean();
  }
  const ClosestPoints begins = SurfaceLocator(giver).Find(centroids, progress.Part(0.0, 0.6));
  const Eigen::MatrixXi& triangles = giver.Triangles();
  const Eigen::MatrixXi isOpposite = FindBoundaryEdges(giver);
  const Eigen::MatrixXd columns = giver.Points().transpose();
  const TriangleFans fans(triangles, giver.Points().rows());
  TriangleWalk walk(triangles, columns, fans);
  // Equal texture coordinates differ by rounding; those of two sides of a seam by much more.
  constexpr double rounding = 1e-9;
  const double same = rounding * std::max(1.0, texture.cwiseAbs().maxCoeff());
  const auto stopsAtBoundary = [&]
  {
    for (int k = 0; k < 3; ++k)
    {
      if (isOpposite(walk.Triangle, k) == 1 && walk.Barycentric(k) < rounding)
      {
        return true;
      }
    }
    return false;
  };
  std::map<int, std::vector<int>> copies; // the new points of a point
  std::vector<Eigen::RowVector2d> added;
  for (std::size_t i = 0; i < polygons.size(); ++i)
  {
    const int begin = triangles(begins.Triangles(static_cast<Eigen::Index>(i)), 0);
    for (int& corner : split.Polygons[i])
    {
      const int point = corner;
      walk.Go(begin, positions.row(point).transpose());
      const Eigen::RowVector2d here =
        walk.Barycentric * texture(triangles.row(walk.Triangle), Eigen::all);
      // A walk that ends inside has reached the position, or a place that hides it: there is no
      // seam between.
      if ((here - found.row(point)).cwiseAbs().maxCoeff() <= same || !stopsAtBoundary())
      {
        continue;
      }
      std::vector<int>& known = copies[point];
      const auto isHere = [&](int copy)
      { return (added[copy] - here).cwiseAbs().maxCoeff() <= same; };
      const auto fitting = std::find_if(known.begin(), known.end(), isHere);
      int copy = 0;
      if (fitting == known.end())
      {
        copy = static_cast<int>(added.size());
        known.push_back(copy);
        added.push_back(here);
        split.Copied.push_back(point);
      }
      else
      {
        copy = *fitting;
      }
      corner = static_cast<int>(positions.rows()) + copy;
    }
    constexpr std::size_t often = 256;
    if (i % often == 0)
    {
      progress(0.6 + 0.4 * static_cast<double>(i) / static_cast<double>(polygons.size()));
    }
  }
  split.Texture.conservativeResize(found.rows() + static_cast<Eigen::Index>(added.size()), 2);
  for (std::size_t k = 0; k < added.size(); ++k)
  {
    split.Texture.row(found.rows() + static_cast<Eigen::Index>(k)) = added[k];
  }
  progress(1.0);
  return split;
}

} // namespace shape
