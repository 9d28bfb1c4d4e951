#include "Solidify/Private/WindingBoundary.h"

#include "Base/DisjointSets.h"
#include "Base/Parallel.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Surface.h"
#include "Solidify/Private/EdgeGroups.h"
#include "Solidify/Private/JoinedSoup.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Whether two triangles on the same points have the same orientation.
bool AreEqual(const Eigen::RowVector3i& first, const Eigen::RowVector3i& second)
{
  for (int k = 0; k < 3; ++k)
  {
    if (second(k) == first(0))
    {
      return second((k + 1) % 3) == first(1);
    }
  }
  return false;
}

/// For each triangle, the number of triangles on its points with its orientation, minus that of the
/// reversed ones; 0 unless it is the first of them.
std::vector<int> CountLayers(const Eigen::MatrixXi& triangles)
{
  const std::vector<int> first = FindSameTriangles(triangles);
  std::vector<int> layers(first.size(), 0);
  for (std::size_t t = 0; t < first.size(); ++t)
  {
    const auto row = static_cast<Eigen::Index>(t);
    layers[first[t]] += AreEqual(triangles.row(first[t]), triangles.row(row)) ? 1 : -1;
  }
  return layers;
}

/// The triangles with layers, once for each, reversed if their number is negative.
struct Layers
{
  explicit Layers(const Eigen::MatrixXi& all, const std::vector<int>& layers)
    : First(layers.size() + 1, 0)
  {
    for (std::size_t t = 0; t < layers.size(); ++t)
    {
      this->First[t + 1] = this->First[t] + std::abs(layers[t]);
    }
    this->Triangles.resize(this->First.back(), 3);
    for (std::size_t t = 0; t < layers.size(); ++t)
    {
      Eigen::RowVector3i corners = all.row(static_cast<Eigen::Index>(t));
      if (layers[t] < 0)
      {
        std::swap(corners(1), corners(2));
      }
      for (Eigen::Index row = this->First[t]; row < this->First[t + 1]; ++row)
      {
        this->Triangles.row(row) = corners;
      }
    }
  }
  /// Returns the triangles on the points of triangle t.
  Eigen::MatrixXi On(int t) const
  {
    return this->Triangles.middleRows(this->First[t], this->First[t + 1] - this->First[t]);
  }
  std::vector<Eigen::Index> First;
  Eigen::MatrixXi Triangles;
};

/// Returns the patch of each triangle with layers.
DisjointSets FindPatches(const Mesh& surface, const std::vector<int>& layers)
{
  std::vector<int> solid;
  for (int t = 0; t < static_cast<int>(layers.size()); ++t)
  {
    if (layers[t] != 0)
    {
      solid.push_back(t);
    }
  }
  DisjointSets patches(static_cast<int>(layers.size()));
  const Eigen::MatrixXi triangles = surface.Triangles(solid, Eigen::all);
  ForEachEdge(SortHalfEdges(triangles, surface.Points.rows()),
    [&](const HalfEdge* begin, const HalfEdge* end)
    {
      if (end - begin != 2)
      {
        return;
      }
      const int first = solid[begin->Triangle], second = solid[begin[1].Triangle];
      const int turn = begin->Begin == begin[1].Begin ? -1 : 1;
      if (layers[first] == turn * layers[second])
      {
        patches.Merge(first, second);
      }
    });
  return patches;
}

double AreaOf(const Mesh& surface, int triangle)
{
  const Eigen::Matrix3d corners = GetCorners(surface, triangle);
  return (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).norm();
}

} // namespace

Mesh OrientCrossingPieces(const Mesh& surface, const Progress& progress)
{
  const std::vector<Mesh> pieces = SplitComponents(surface);
  const shape::Surface whole = surface;
  // The largest piece is the outside of something.
  std::vector<double> volumes;
  for (const Mesh& piece : pieces)
  {
    volumes.push_back(ComputeEnclosedVolume(piece));
  }
  const double largest = *std::max_element(
    volumes.begin(), volumes.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  const double side = largest < 0.0 ? -1.0 : 1.0;
  std::vector<char> isReversed(pieces.size(), side < 0.0);
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    progress(static_cast<double>(i) / static_cast<double>(pieces.size()));
    if (side * volumes[i] >= 0.0)
    {
      continue;
    }
    constexpr Eigen::Index samples = 7;
    const Eigen::Index points = pieces[i].Points.rows(), count = std::min(samples, points);
    int inside = 0;
    for (Eigen::Index k = 0; k < count; ++k)
    {
      const Eigen::RowVector3d position = pieces[i].Points.row(k * points / count);
      double winding = 0.0;
      for (std::size_t j = 0; j < pieces.size(); ++j)
      {
        winding += side * volumes[j] < 0.0
          ? 0.0
          : side * ComputeWindingNumber(pieces[j].Points, pieces[j].Triangles, position);
      }
      inside += winding > 0.5;
    }
    if (2 * inside <= count)
    {
      isReversed[i] = isReversed[i] == 0;
    }
  }
  Mesh oriented = surface;
  for (Eigen::Index t = 0; t < oriented.Triangles.rows(); ++t)
  {
    if (isReversed[whole.Topology().ComponentId(oriented.Triangles(t, 0))] != 0)
    {
      std::swap(oriented.Triangles(t, 1), oriented.Triangles(t, 2));
    }
  }
  return oriented;
}

WindingBoundary ExtractWindingBoundary(const Mesh& surface, const Progress& progress)
{
  const std::vector<int> layers = CountLayers(surface.Triangles);
  DisjointSets sets = FindPatches(surface, layers);
  const auto count = static_cast<int>(layers.size());
  std::vector<int> largest(count, -1), patches;
  std::vector<double> areas(count, -1.0);
  for (int t = 0; t < count; ++t)
  {
    const int patch = sets.Find(t);
    if (layers[t] != 0 && AreaOf(surface, t) > areas[patch])
    {
      areas[patch] = AreaOf(surface, t);
      largest[patch] = t;
    }
  }
  std::copy_if(largest.begin(), largest.end(), std::back_inserter(patches),
    [](int triangle) { return triangle >= 0; });
  const Layers all(surface.Triangles, layers);
  // The winding number in front of each patch's largest triangle.
  std::vector<int> front(count, 0);
  ParallelFor(
    static_cast<int>(patches.size()), 1,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const int t = patches[i];
        const Eigen::RowVector3d centre = GetCorners(surface, t).colwise().mean();
        // In the triangle's own plane, its solid angle has no sign, and the number is the mean of
        // those in front and behind.
        const double mean = ComputeWindingNumber(surface.Points, all.Triangles, centre) -
          ComputeWindingNumber(surface.Points, all.On(t), centre);
        front[t] = static_cast<int>(std::lround(mean - 0.5 * layers[t]));
      }
    },
    progress);
  WindingBoundary boundary{ { surface.Points, surface.Triangles }, {} };
  std::vector<int> parents;
  for (int t = 0; t < count; ++t)
  {
    const int largestOf = layers[t] != 0 ? largest[sets.Find(t)] : -1;
    if (largestOf < 0)
    {
      continue;
    }
    // Within a patch, triangles face the same side if their layers have the same sign.
    const bool faces = (layers[t] > 0) == (layers[largestOf] > 0);
    const int ahead = front[largestOf], behind = ahead + layers[largestOf];
    if ((ahead >= 1) == (behind >= 1))
    {
      continue;
    }
    const auto row = static_cast<Eigen::Index>(parents.size());
    boundary.Surface.Triangles.row(row) = surface.Triangles.row(t);
    if ((ahead >= 1) == faces)
    {
      std::swap(boundary.Surface.Triangles(row, 1), boundary.Surface.Triangles(row, 2));
    }
    parents.push_back(t);
  }
  boundary.Surface.Triangles.conservativeResize(static_cast<Eigen::Index>(parents.size()), 3);
  boundary.Parents =
    Eigen::Map<const Eigen::VectorXi>(parents.data(), static_cast<Eigen::Index>(parents.size()));
  return boundary;
}

} // namespace shape
