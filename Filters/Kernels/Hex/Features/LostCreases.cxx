#include "Hex/Features/LostCreases.h"

#include "Search/ClosestPoint.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace shape
{
namespace
{

/// Returns the points of a polyline and the middles of its edges.
Eigen::MatrixXd SampleLine(const CreaseLine& line)
{
  Eigen::MatrixXd samples(2 * line.rows() - 1, 3);
  samples.topRows(line.rows()) = line;
  samples.bottomRows(line.rows() - 1) =
    0.5 * (line.topRows(line.rows() - 1) + line.bottomRows(line.rows() - 1));
  return samples;
}

} // namespace

std::vector<CreaseLine> BuildCreaseLines(const Mesh& surface, const SurfaceFeatures& features)
{
  std::vector<CreaseLine> lines;
  for (const FeatureCurve& curve : features.Curves)
  {
    std::vector<int> points = curve.Points;
    if (curve.Closed)
    {
      points.push_back(points.front());
    }
    lines.emplace_back(surface.Points(points, Eigen::all));
  }
  return lines;
}

double ComputeLength(const std::vector<CreaseLine>& lines)
{
  double length = 0.0;
  for (const CreaseLine& line : lines)
  {
    length +=
      (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1)).rowwise().norm().sum();
  }
  return length;
}

Eigen::RowVector3d FindMidpoint(const CreaseLine& line)
{
  double left = 0.5 * ComputeLength({ line });
  for (Eigen::Index i = 0; i + 1 < line.rows(); ++i)
  {
    const Eigen::RowVector3d step = line.row(i + 1) - line.row(i);
    const double length = step.norm();
    if (left <= length && length > 0.0)
    {
      return line.row(i) + left / length * step;
    }
    left -= length;
  }
  return line.bottomRows<1>(); // rounding: the last step was a little too short
}

std::vector<CreaseLine> FindUncovered(
  const std::vector<CreaseLine>& lines, const std::vector<CreaseLine>& others, double tolerance)
{
  if (others.empty())
  {
    return lines;
  }
  const SurfaceLocator near(BuildFlatTriangles(others));
  std::vector<CreaseLine> uncovered;
  std::copy_if(lines.begin(), lines.end(), std::back_inserter(uncovered),
    [&](const CreaseLine& line)
    { return near.Find(SampleLine(line)).Distances.maxCoeff() > tolerance; });
  return uncovered;
}

std::set<int> FindNearestCurves(
  const Mesh& surface, const SurfaceFeatures& features, const Eigen::MatrixXd& positions)
{
  if (features.Curves.empty() || positions.rows() == 0)
  {
    return {};
  }
  const std::vector<CreaseLine> lines = BuildCreaseLines(surface, features);
  std::vector<int> curveOf; // of each edge
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    curveOf.insert(curveOf.end(), lines[i].rows() - 1, static_cast<int>(i));
  }
  const Eigen::VectorXi edges = SurfaceLocator(BuildFlatTriangles(lines)).Find(positions).Triangles;
  std::set<int> curves;
  std::transform(edges.begin(), edges.end(), std::inserter(curves, curves.end()),
    [&](int edge) { return curveOf[edge]; });
  return curves;
}

SurfaceFeatures WithoutCurves(
  const Surface& surface, const SurfaceFeatures& features, const std::set<int>& curves)
{
  std::vector<int> groupOf(features.Patches);
  std::iota(groupOf.begin(), groupOf.end(), 0);
  for (const int curve : curves)
  {
    const auto [one, other] = features.Curves[curve].Patches;
    std::replace(groupOf.begin(), groupOf.end(), int(groupOf[one]), int(groupOf[other]));
  }
  const Eigen::Map<const Eigen::VectorXi> groups(
    groupOf.data(), static_cast<Eigen::Index>(groupOf.size()));
  SurfaceFeatures fewer = FindFeatures(surface, groups(features.PatchOf).eval(), 0.0);
  fewer.CreaseLength = features.CreaseLength;
  fewer.CurveLength = std::min(fewer.CurveLength, features.CurveLength);
  return fewer;
}

} // namespace shape
