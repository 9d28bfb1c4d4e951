#include "Geodesics/EdgeGeodesics.h"

#include <limits>

namespace shape
{

Eigen::VectorXd ComputeEdgeGeodesics(
  const Surface& surface, const GraphSources& sources, const Progress& progress)
{
  Eigen::VectorXd distances =
    Eigen::VectorXd::Constant(surface.Points().rows(), std::numeric_limits<double>::infinity());
  LowerDistances(*GetEdgeGraph(surface), sources, distances, progress);
  progress(1.0);
  return distances;
}

} // namespace shape
