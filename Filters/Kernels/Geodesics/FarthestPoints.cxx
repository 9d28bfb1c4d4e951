#include "Geodesics/FarthestPoints.h"

#include "Geodesics/EdgeGeodesics.h"

#include <limits>

namespace shape
{

std::vector<int> SampleFarthestPoints(const Mesh& mesh, int count, const Progress& progress)
{
  std::vector<int> samples = { mesh.Triangles.minCoeff() };
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(mesh.Points.rows(), -1.0);
  for (const int point : mesh.Triangles.reshaped())
  {
    nearest(point) = std::numeric_limits<double>::infinity();
  }
  const EdgeGraph edges(mesh);
  while (static_cast<int>(samples.size()) < count)
  {
    edges.Lower(nearest, { { samples.back() }, Eigen::VectorXd::Zero(1) });
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
