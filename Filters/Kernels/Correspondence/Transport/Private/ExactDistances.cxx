#include "Correspondence/Transport/Private/ExactDistances.h"

#include "Base/Parallel.h"
#include "Geodesics/ExactGeodesics.h"

namespace shape
{

Eigen::MatrixXd ComputeExactDistances(
  const Surface& surface, const SurfacePoints& sources, const Progress& progress)
{
  Eigen::MatrixXd distances(surface.Points().rows(), sources.Triangles.size());
  surface.HalfEdges(); // before the threads, which would wait for it
  ParallelFor(
    static_cast<int>(sources.Triangles.size()), 1,
    [&](int begin, int end)
    {
      for (int k = begin; k < end; ++k)
      {
        ClosestPoints seed;
        seed.Triangles = sources.Triangles.segment(k, 1);
        seed.Barycentrics = sources.Barycentrics.row(k);
        seed.Positions =
          GetPosition(surface, { sources.Triangles(k), sources.Barycentrics.row(k) });
        seed.Distances = Eigen::VectorXd::Zero(1);
        distances.col(k) = ComputeExactGeodesics(surface, seed);
      }
    },
    progress);
  return distances;
}

} // namespace shape
