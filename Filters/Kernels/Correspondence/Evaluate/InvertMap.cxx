#include "Correspondence/Evaluate/InvertMap.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/VertexNormals.h"
#include "Search/TriangleTree.h"

#include <cmath>

namespace shape
{

SurfacePoints InvertMap(const Surface& surface, const SurfacePoints& images, const Surface& target,
  const Progress& progress)
{
  if (surface.Triangles().rows() == 0 || target.Triangles().rows() == 0)
  {
    throw InvalidInput("a map can only be inverted between surfaces with triangles");
  }
  // Beside the position, the scaled normal: opposite sheets are as far apart as a tenth of the
  // root of the area, even where they touch.
  constexpr double share = 0.05;
  const double scale = share * std::sqrt(ComputeArea(target));
  Eigen::MatrixXd rows(target.Points().rows(), 6);
  rows << target.Points(), scale * GetVertexNormals(target);
  const TriangleTree tree(surface.Triangles(), PullBack(images, target.Triangles(), rows));
  SurfacePoints inverse{ Eigen::VectorXi(rows.rows()), Eigen::MatrixXd(rows.rows(), 3) };
  constexpr int grain = 256;
  ParallelFor(
    static_cast<int>(rows.rows()), grain,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const NearestTriangle nearest = tree.Find(rows.row(i), 0);
        inverse.Triangles(i) = nearest.Triangle;
        inverse.Barycentrics.row(i) = nearest.Barycentric;
      }
    },
    progress);
  return inverse;
}

} // namespace shape
