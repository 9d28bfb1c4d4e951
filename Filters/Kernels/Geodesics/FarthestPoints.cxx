#include "Geodesics/FarthestPoints.h"

#include "Mesh/Graph.h"

#include <limits>
#include <memory>

namespace shape
{

std::vector<int> SampleFarthestPoints(const Surface& surface, int count, const Progress& progress)
{
  std::vector<int> samples = { surface.Triangles().minCoeff() };
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

} // namespace shape
