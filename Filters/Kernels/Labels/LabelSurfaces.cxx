#include "Labels/LabelSurfaces.h"

#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Labels/Private/Islands.h"
#include "Labels/Private/NetSmoothing.h"
#include "Labels/Private/RegionVolumes.h"
#include "Labels/Private/SurfaceNet.h"
#include "Labels/Private/TouchingRegions.h"
#include "Mesh/RegionSurfaces.h"
#include "Mesh/Topology.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace shape
{
namespace
{

void RequireImage(const LabelImage& image)
{
  if (image.Labels.empty())
  {
    throw InvalidInput("the image has no voxels");
  }
  const double volume = image.Axes.determinant();
  if (!image.Axes.allFinite() || !image.Origin.allFinite() || volume == 0.0)
  {
    throw InvalidInput("the spacing, the directions or the origin of the image are not finite, or "
                       "two directions are parallel; correct them");
  }
}

/// Makes all labels but these the outside, and returns the number of voxels of each that is left.
std::map<int, double> KeepLabels(LabelImage& image, const std::vector<int>& kept)
{
  const std::set<int> wanted(kept.begin(), kept.end());
  std::map<int, double> voxels;
  for (int& label : image.Labels)
  {
    if (!wanted.empty() && !wanted.count(label))
    {
      label = 0;
    }
    if (label != 0)
    {
      ++voxels[label];
    }
  }
  return voxels;
}

/// Divides quadrangles along their shorter diagonals.
void ChooseDiagonals(SurfaceNet& net)
{
  for (Eigen::Index first = 0; first < 2 * static_cast<Eigen::Index>(net.Quads); first += 2)
  {
    // The halves are (a, b, c) and (a, c, d), also after a change.
    const Eigen::RowVector3i half = net.Triangles.row(first);
    const int a = half(0), b = half(1), c = half(2), d = net.Triangles(first + 1, 2);
    const auto squared = [&](int i, int j)
    { return (net.Points.row(i) - net.Points.row(j)).squaredNorm(); };
    if (squared(b, d) < squared(a, c))
    {
      net.Triangles.row(first) << b, c, d;
      net.Triangles.row(first + 1) << b, d, a;
    }
  }
}

/// Where triangles intersect, moves the points back towards the unsmoothed net, again and again.
/// Returns the number of intersections that are left.
int RemoveIntersections(
  SurfaceNet& net, const Eigen::MatrixXd& unsmoothed, const Progress& progress)
{
  constexpr int rounds = 12;
  // Short steps first, because they are mostly enough, and keep curves straight.
  const auto stepOf = [](int round) { return round < 6 ? 0.125 : 0.5; };
  std::vector<int> order(net.Triangles.rows());
  std::iota(order.begin(), order.end(), 0);
  int first = 0;
  for (int round = 0;; ++round)
  {
    const std::vector<Crossing> crossings = FindSelfIntersectionsFrom(
      Mesh{ net.Points, net.Triangles(order, Eigen::all) }, first, std::numeric_limits<int>::max(),
      progress.Part(double(round) / (rounds + 1), (round + 1.0) / (rounds + 1)));
    if (crossings.empty() || round == rounds)
    {
      return static_cast<int>(crossings.size());
    }
    std::vector<char> isMoved(net.Points.rows(), 0);
    for (const Crossing& crossing : crossings)
    {
      for (const int triangle : { crossing.First, crossing.Second })
      {
        for (const int corner : Eigen::RowVector3i(net.Triangles.row(order[triangle])))
        {
          isMoved[corner] = 1;
        }
      }
    }
    for (Eigen::Index point = 0; point < net.Points.rows(); ++point)
    {
      if (isMoved[point])
      {
        net.Points.row(point) += stepOf(round) * (unsmoothed.row(point) - net.Points.row(point));
      }
    }
    // Only pairs with a moved triangle may intersect now. Moved triangles come last.
    const auto isStill = [&](int triangle)
    {
      const Eigen::RowVector3i corners = net.Triangles.row(triangle);
      return !isMoved[corners(0)] && !isMoved[corners(1)] && !isMoved[corners(2)];
    };
    first =
      static_cast<int>(std::stable_partition(order.begin(), order.end(), isStill) - order.begin());
  }
}

/// Finds the curves along edges of three or more triangles.
void FindCurves(LabelSurfacesResult& result)
{
  std::map<std::pair<int, int>, int> uses;
  // Only points with three regions have such edges.
  std::vector<std::array<int, 3>> seen(result.Points.rows(), { -1, -1, -1 });
  std::vector<char> isJunction(result.Points.rows(), 0);
  for (Eigen::Index t = 0; t < result.Triangles.rows(); ++t)
  {
    for (const int corner : Eigen::RowVector3i(result.Triangles.row(t)))
    {
      for (const int region : { result.Regions(t, 0), result.Regions(t, 1) })
      {
        auto& own = seen[corner];
        for (int& slot : own)
        {
          if (slot == region)
          {
            break;
          }
          if (slot == -1)
          {
            slot = region;
            break;
          }
        }
        isJunction[corner] = own[2] != -1;
      }
    }
  }
  for (Eigen::Index t = 0; t < result.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = result.Triangles(t, k), b = result.Triangles(t, (k + 1) % 3);
      if (isJunction[a] && isJunction[b])
      {
        ++uses[{ std::min(a, b), std::max(a, b) }];
      }
    }
  }
  std::map<int, std::set<int>> neighbours;
  for (const auto& [edge, count] : uses)
  {
    if (count > 2)
    {
      neighbours[edge.first].insert(edge.second);
      neighbours[edge.second].insert(edge.first);
    }
  }
  for (const auto& [point, others] : neighbours)
  {
    if (others.size() != 2)
    {
      result.Corners.push_back(point);
    }
  }
  const auto follow = [&](int start, int next)
  {
    std::vector<int> curve = { start };
    int previous = start;
    neighbours[start].erase(next);
    neighbours[next].erase(start);
    while (true)
    {
      curve.push_back(next);
      const bool isEnd =
        next == start || std::binary_search(result.Corners.begin(), result.Corners.end(), next);
      if (isEnd)
      {
        break;
      }
      previous = next;
      next = *neighbours[previous].begin();
      neighbours[previous].erase(next);
      neighbours[next].erase(previous);
    }
    result.Curves.push_back(curve);
  };
  for (const int corner : result.Corners)
  {
    while (!neighbours[corner].empty())
    {
      follow(corner, *neighbours[corner].begin());
    }
  }
  for (auto& [point, others] : neighbours)
  {
    if (!others.empty())
    {
      follow(point, *others.begin());
    }
  }
}

/// Measures the surface of each region. voxels: their number in each region, of this volume.
std::vector<LabelRegion> MeasureRegions(const LabelSurfacesResult& result,
  const std::map<int, double>& voxels, double voxel, const Progress& progress)
{
  const Mesh all{ result.Points, result.Triangles };
  const RegionSurfaces regions(all, result.Regions);
  std::vector<LabelRegion> measured;
  for (const auto& [label, count] : voxels)
  {
    progress(static_cast<double>(measured.size()) / static_cast<double>(voxels.size()));
    const Mesh surface = regions.Extract(label);
    const Topology topology = ComputeTopology(surface);
    measured.push_back({ label, count * voxel, ComputeEnclosedVolume(surface), topology.Components,
      topology.EulerNumber });
  }
  return measured;
}

} // namespace

LabelSurfacesResult ExtractLabelSurfaces(
  LabelImage image, const LabelSurfacesOptions& options, const Progress& progress)
{
  RequireOption(options.Smoothing >= 0.0 && options.Smoothing <= 40.0, "Smoothing",
    options.Smoothing, "a number of voxels from 0 to 40");
  RequireOption(
    options.SmallestIsland >= 0, "SmallestIsland", options.SmallestIsland, "0 or more voxels");
  RequireImage(image);
  KeepLabels(image, options.Labels);
  LabelSurfacesResult result;
  const DissolvedIslands islands =
    DissolveIslands(image, options.SmallestIsland, progress.Part(0.0, 0.1, "dissolving islands"));
  result.Islands = islands.Count;
  result.IslandVoxels = islands.Voxels;
  const std::map<int, double> voxels = KeepLabels(image, {});
  if (voxels.empty())
  {
    throw InvalidInput("the image has no label but the outside, 0; choose another array, other "
                       "labels or smaller islands");
  }

  SurfaceNet net = BuildSurfaceNet(image, progress.Part(0.1, 0.3, "separating the regions"));
  const Eigen::MatrixXd unsmoothed = net.Points;
  const std::map<int, double> interpolated = ComputeRegionVolumes(net);
  SmoothNet(net, options.Smoothing, progress.Part(0.3, 0.7, "smoothing the interfaces"));
  ChooseDiagonals(net);
  if (options.Smoothing > 0.0)
  {
    RestoreVolumes(net, image.Values.empty() ? voxels : interpolated);
  }
  result.Intersections =
    RemoveIntersections(net, unsmoothed, progress.Part(0.7, 0.9, "removing intersections"));
  result.SplitPoints =
    SplitTouchingRegions(net.Points, net.Triangles, net.Regions, net.JunctionPoints);
  result.Points = (net.Points * image.Axes.transpose()).rowwise() + image.Origin;
  result.Triangles = std::move(net.Triangles);
  result.Regions = std::move(net.Regions);
  const double voxel = image.Axes.determinant();
  if (voxel < 0.0)
  {
    // The axes mirror the net.
    result.Triangles.col(0).swap(result.Triangles.col(1));
  }
  progress.Part(0.9, 0.95, "following curves where regions meet")(0.0);
  FindCurves(result);
  result.RegionsByLabel = MeasureRegions(
    result, voxels, std::abs(voxel), progress.Part(0.95, 1.0, "measuring the regions"));
  progress(1.0);
  return result;
}

} // namespace shape
