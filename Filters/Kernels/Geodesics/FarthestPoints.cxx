#include "Geodesics/FarthestPoints.h"

#include "Mesh/Graph.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

namespace shape
{

std::vector<int> SampleFarthestPoints(
  const Surface& surface, int count, const Progress& progress, int start)
{
  std::vector<int> samples = { start >= 0 ? start : surface.Triangles().minCoeff() };
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(surface.Points().rows(), -1.0);
  for (const int point : surface.Triangles().reshaped())
  {
    nearest(point) = std::numeric_limits<double>::infinity();
  }
  const std::shared_ptr<const Graph> edges = GetEdgeGraph(surface);
  while (static_cast<int>(samples.size()) < count)
  {
    // Only distances that the new sample shortens are visited, which are fewer for each sample.
    LowerDistances(*edges, { { samples.back() }, Eigen::VectorXd::Zero(1) }, nearest);
    Eigen::Index farthest = 0;
    if (nearest.maxCoeff(&farthest) <= 0.0)
    {
      break;
    }
    samples.push_back(static_cast<int>(farthest));
    progress(static_cast<double>(samples.size()) / count);
  }
  return samples;
}

int FindRemotestPoint(const Surface& surface)
{
  const Eigen::VectorXd areas = ComputePointAreas(surface);
  const Eigen::RowVector3d centroid =
    areas.transpose() * surface.Points() / std::max(areas.sum(), 1e-300);
  const Eigen::VectorXd distances = (surface.Points().rowwise() - centroid).rowwise().norm();
  double farthest = 0.0;
  for (const int point : surface.Triangles().reshaped())
  {
    farthest = std::max(farthest, distances(point));
  }
  // Far above rounding, which depends on the order of the sums.
  constexpr double equal = 1.0 - 1e-9;
  const auto position = [&](int i)
  {
    return std::array<double, 3>{ surface.Points()(i, 0), surface.Points()(i, 1),
      surface.Points()(i, 2) };
  };
  int remotest = -1;
  for (const int point : surface.Triangles().reshaped())
  {
    if (distances(point) >= equal * farthest &&
      (remotest < 0 || position(point) > position(remotest)))
    {
      remotest = point;
    }
  }
  return remotest;
}

} // namespace shape
