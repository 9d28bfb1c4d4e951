#include "Hex/Polycube/Polycube.h"

#include "Base/Errors.h"
#include "Hex/Polycube/Private/AxisAlignment.h"
#include "Hex/Polycube/Private/Charts.h"
#include "Hex/Polycube/Private/PolycubeMap.h"
#include "Search/ClosestPoint.h"
#include "Solids/SolidBoundary.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// Rings around inverted triangles that move with them: more are tried while some stay inverted.
constexpr int Rings[] = { 2, 4, 8 };
/// A bound only: relabelling ends when nothing changes.
constexpr int MaximumRelabellings = 10;

/// Points move in the planes of their charts. Points with indices beyond the surface's are tips of
/// tetrahedra, which move parallel to the plane of their triangle.
class InPlanes : public PointConstraint
{
public:
  /// planes (n x 3): whether a coordinate is fixed. tips: the axis of each.
  InPlanes(std::vector<std::array<bool, 3>> planes)
    : Fixed(std::move(planes))
  {
  }

  int Freedom(int point) const override
  {
    return static_cast<int>(
      std::count(this->Fixed[point].begin(), this->Fixed[point].end(), false));
  }

  PointDirections Directions(int point, const Eigen::RowVector3d& /*position*/) const override
  {
    PointDirections directions(3, this->Freedom(point));
    for (int axis = 0, column = 0; axis < 3; ++axis)
    {
      if (!this->Fixed[point][axis])
      {
        directions.col(column++) = Eigen::Vector3d::Unit(axis);
      }
    }
    return directions;
  }

  Eigen::RowVector3d Nearest(int /*point*/, const Eigen::RowVector3d& position) const override
  {
    return position; // the directions keep it in its planes
  }

private:
  std::vector<std::array<bool, 3>> Fixed;
};

/// Keeps the largest of the pieces into which each chart of the coarse solid falls. Each other
/// piece gets the label with which it shares the longest border.
void RemoveIslands(
  const Mesh& surface, const Eigen::VectorXi& coarseCharts, Eigen::VectorXi& labels)
{
  const Charts pieces = FindCharts(surface, labels);
  std::map<int, int> largest; // the largest piece of each coarse chart
  std::vector<int> origin(pieces.Count(), -1);
  for (Eigen::Index f = 0; f < labels.size(); ++f)
  {
    const int piece = pieces.Of(f);
    if (origin[piece] < 0)
    {
      origin[piece] = coarseCharts(f);
      const auto [found, fresh] = largest.emplace(origin[piece], piece);
      if (!fresh && pieces.Areas(piece) > pieces.Areas(found->second))
      {
        found->second = piece;
      }
    }
  }
  std::map<int, std::map<int, double>> boundaries; // border length of small pieces by label
  for (const Charts::Border& boundary : pieces.Borders)
  {
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < boundary.Points.size(); ++i)
    {
      length +=
        (surface.Points.row(boundary.Points[i + 1]) - surface.Points.row(boundary.Points[i]))
          .norm();
    }
    boundaries[boundary.First][pieces.Labels[boundary.Second]] += length;
    boundaries[boundary.Second][pieces.Labels[boundary.First]] += length;
  }
  for (Eigen::Index f = 0; f < labels.size(); ++f)
  {
    const int piece = pieces.Of(f);
    if (const auto around = boundaries.find(piece);
        largest.at(origin[piece]) != piece && around != boundaries.end())
    {
      labels(f) = std::max_element(around->second.begin(), around->second.end(),
        [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first;
    }
  }
}

/// Transfers the labels of the closest triangles of the coarse solid to the surface. A triangle
/// whose corners would all lie on the border of another chart would have no area; it joins that
/// chart.
Eigen::VectorXi TransferLabels(const Mesh& surface, const PolycubeMap& map,
  const SurfaceLocator& coarse, const Progress& progress)
{
  const Eigen::VectorXi closest = coarse.Find(ComputeCentroids(surface), progress).Triangles;
  Eigen::VectorXi labels = map.Labels(closest);
  RemoveIslands(surface, map.Charts.Of(closest), labels);
  for (int round = 0; round < MaximumRelabellings; ++round)
  {
    const Charts charts = FindCharts(surface, labels);
    Eigen::VectorXi next = labels;
    for (Eigen::Index f = 0; f < labels.size(); ++f)
    {
      const auto c = surface.Triangles.row(f);
      for (const int chart : charts.AtPoint[c(0)])
      {
        const auto touches = [&](int v)
        {
          const std::vector<int>& around = charts.AtPoint[v];
          return std::find(around.begin(), around.end(), chart) != around.end();
        };
        // In odd rounds triangles only join larger charts, so that two charts do not exchange a
        // triangle for ever.
        if (chart != charts.Of(f) && touches(c(1)) && touches(c(2)) &&
          (round % 2 == 0 || charts.Areas(chart) > charts.Areas(charts.Of(f))))
        {
          next(f) = charts.Labels[chart];
        }
      }
    }
    if (next == labels)
    {
      break;
    }
    labels = std::move(next);
  }
  return labels;
}

/// Moves the points into the planes of their triangles' charts.
std::vector<std::array<bool, 3>> Snap(
  const Mesh& surface, const Charts& charts, Eigen::MatrixXd& positions)
{
  // The plane of a chart is where most of its area lies.
  std::vector<std::vector<double>> coordinates(charts.Count());
  for (Eigen::Index f = 0; f < surface.Triangles.rows(); ++f)
  {
    const int chart = charts.Of(f);
    for (const int v : surface.Triangles.row(f))
    {
      coordinates[chart].push_back(positions(v, charts.Labels[chart] / 2));
    }
  }
  std::vector<std::array<bool, 3>> fixed(surface.Points.rows(), { false, false, false });
  for (std::vector<double>& values : coordinates)
  {
    // The median: a few triangles off the plane do not change it.
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    values[0] = std::round(values[values.size() / 2]);
  }
  for (std::size_t v = 0; v < charts.AtPoint.size(); ++v)
  {
    for (const int chart : charts.AtPoint[v])
    {
      positions(v, charts.Labels[chart] / 2) = coordinates[chart][0];
      fixed[v][charts.Labels[chart] / 2] = true;
    }
  }
  return fixed;
}

/// Moves the points of inverted triangles and of this many rings around them.
void Untangle(const Mesh& surface, const Eigen::VectorXi& labels,
  const std::vector<std::array<bool, 3>>& fixed, int rings, Eigen::MatrixXd& positions,
  const Progress& progress)
{
  std::vector<char> marked = FindInvertedTriangles({ positions, surface.Triangles }, labels);
  std::vector<char> points(surface.Points.rows(), 0);
  for (int ring = 0; ring < rings; ++ring)
  {
    for (Eigen::Index f = 0; f < labels.size(); ++f)
    {
      for (int k = 0; marked[f] && k < 3; ++k)
      {
        points[surface.Triangles(f, k)] = 1;
      }
    }
    for (Eigen::Index f = 0; f < labels.size(); ++f)
    {
      const auto c = surface.Triangles.row(f);
      marked[f] = marked[f] || points[c(0)] || points[c(1)] || points[c(2)];
    }
  }
  // Each triangle forms a tetrahedron with its own tip, which slides at constant height.
  SimplexPatch patch;
  std::vector<std::array<bool, 3>> planes = fixed;
  Eigen::MatrixXd all = positions;
  std::vector<Eigen::RowVector3d> tips;
  for (int f = 0; f < labels.size(); ++f)
  {
    if (!marked[f])
    {
      continue;
    }
    const Eigen::Matrix3d corners = GetCorners(surface, f);
    const Eigen::Vector3d first = (corners.row(1) - corners.row(0)).transpose();
    const Eigen::Vector3d second = (corners.row(2) - corners.row(0)).transpose();
    const Eigen::Vector3d normal = first.cross(second);
    // As high as the triangle is wide: the energy then measures the triangle's shape.
    const double height = std::sqrt(normal.norm());
    if (!(height > 0.0))
    {
      continue;
    }
    Eigen::Matrix3d edges;
    edges << first, second, (first + second) / 3.0 + height * normal.normalized();
    const auto c = surface.Triangles.row(f);
    const int tip = static_cast<int>(positions.rows() + tips.size());
    patch.Simplices.push_back({ { c(0), c(1), c(2), tip }, ComputeHatGradients(edges) });
    patch.FreePoints.push_back(tip);
    tips.emplace_back((positions.row(c(0)) + positions.row(c(1)) + positions.row(c(2))) / 3.0 +
      height * GetLabelAxis(labels(f)));
    planes.push_back({ false, false, false });
    planes.back()[labels(f) / 2] = true;
  }
  all.conservativeResize(positions.rows() + static_cast<Eigen::Index>(tips.size()), 3);
  for (std::size_t i = 0; i < tips.size(); ++i)
  {
    all.row(positions.rows() + i) = tips[i];
  }
  const InPlanes constraint(planes);
  for (int v = 0; v < static_cast<int>(points.size()); ++v)
  {
    if (points[v] && constraint.Freedom(v) > 0)
    {
      patch.FreePoints.push_back(v);
    }
  }
  PatchOptions options;
  options.MaximumSteps = 60;
  options.FromSmoothest = false;
  MinimizeEnergy(all, patch, &constraint, options, progress);
  positions = all.topRows(positions.rows());
}

/// Lists the charts concerned, those with the most triangles first.
std::string DescribeTurned(
  const Mesh& polycube, const Eigen::VectorXi& labels, const Charts& charts)
{
  std::map<int, int> counts;
  const std::vector<char> turned = FindInvertedTriangles(polycube, labels);
  for (std::size_t f = 0; f < turned.size(); ++f)
  {
    counts[charts.Of(static_cast<Eigen::Index>(f))] += turned[f];
  }
  std::vector<std::pair<int, int>> order;
  for (const auto& [chart, count] : counts)
  {
    order.emplace_back(count, chart);
  }
  std::sort(order.rbegin(), order.rend());
  std::string text;
  constexpr std::size_t maximum = 3;
  for (std::size_t i = 0; i < std::min(maximum, order.size()) && order[i].first > 0; ++i)
  {
    text += (i > 0 ? ", " : "") + std::to_string(order[i].first) + " of " +
      DescribeChart(charts, order[i].second);
  }
  return text;
}

} // namespace

// 1. FindPolycubeMap finds the polycube of a coarse solid.
// 2. TransferLabels: the labels of the closest coarse triangles.
// 3. The points are mapped by the closest points of the coarse surface, and moved into the planes
//    of their charts (Snap).
// 4. Untangle: inverted triangles are repaired within their planes.
PolycubeResult BuildPolycube(
  const Surface& given, const PolycubeOptions& options, const Progress& progress)
{
  const Surface surface = OrientOutwards(given);
  RequireOption(options.TargetEdgeLength >= 0.0 && std::isfinite(options.TargetEdgeLength),
    "TargetEdgeLength", options.TargetEdgeLength,
    "positive and finite, or 0 for an automatic length");
  PolycubeMapOptions mapOptions;
  mapOptions.CellSize = options.TargetEdgeLength;
  mapOptions.Facing = true;
  const PolycubeMap map =
    FindPolycubeMap(surface, options.Compactness, mapOptions, progress.Part(0.0, 0.8));
  const SurfaceLocator coarse(map.Solid.Surface());
  Mesh scaled = surface;
  // In cells, as the positions are: triangles are compared with those of the undeformed surface.
  scaled.Points /= map.CellSize;
  PolycubeResult result;
  result.EdgeLength = map.CellSize;
  result.Distortion = map.Distortion;
  result.Labels =
    TransferLabels(surface, map, coarse, progress.Part(0.8, 0.85, "transferring the patches"));
  const Charts charts = FindCharts(surface, result.Labels);
  result.Charts = charts.Count();
  result.Corners = static_cast<int>(std::count_if(charts.AtPoint.begin(), charts.AtPoint.end(),
    [](const std::vector<int>& around) { return around.size() > 2; }));
  Eigen::MatrixXd positions = PullBack(coarse.Find(surface.Points()), map.Solid.Triangles,
    map.Positions.topRows(map.Solid.SurfacePointCount));
  const std::vector<std::array<bool, 3>> fixed = Snap(surface, charts, positions);
  const auto count = [&]
  {
    const std::vector<char> turned =
      FindInvertedTriangles({ positions, surface.Triangles() }, result.Labels);
    return std::count(turned.begin(), turned.end(), 1);
  };
  for (const int rings : Rings)
  {
    if (count() > 0)
    {
      Untangle(scaled, result.Labels, fixed, rings, positions,
        progress.Part(0.85, 1.0, "untangling the polycube map"));
    }
  }
  const auto turned = count();
  if (turned > 0)
  {
    throw SolveFailure("the polycube of " + std::to_string(map.Charts.Count()) +
      " charts inverts " + std::to_string(turned) + " of " +
      std::to_string(surface.Triangles().rows()) +
      " triangles: " + DescribeTurned({ positions, surface.Triangles() }, result.Labels, charts) +
      "; divide the triangles with Subdivide, or try another Compactness");
  }
  result.Positions = map.CellSize * positions;
  progress(1.0);
  return result;
}

int FindPolygonLabel(const Eigen::MatrixXd& corners)
{
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  for (Eigen::Index k = 1; k + 1 < corners.rows(); ++k)
  {
    const Eigen::Vector3d one = (corners.row(k) - corners.row(0)).transpose();
    const Eigen::Vector3d other = (corners.row(k + 1) - corners.row(0)).transpose();
    vector += one.cross(other);
  }
  Eigen::Index axis;
  if (!(vector.cwiseAbs().maxCoeff(&axis) > 0.0))
  {
    return -1;
  }
  return static_cast<int>(2 * axis) + (vector(axis) < 0.0 ? 1 : 0);
}

} // namespace shape
