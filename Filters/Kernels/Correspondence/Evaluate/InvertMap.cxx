#include "Correspondence/Evaluate/InvertMap.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/VertexNormals.h"
#include "Search/ClosestPoint.h"
#include "Search/TriangleTree.h"

#include <cmath>
#include <vector>

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
  const Eigen::MatrixXd moved = PullBack(images, target.Triangles(), rows);
  SurfacePoints inverse =
    SurfaceLocator(surface.WithPoints(moved.leftCols(3))).Find(target.Points(), progress);
  const Eigen::MatrixXd found = PullBack(inverse, surface.Triangles(), moved);
  std::vector<int> opposite; // points whose nearest sheet faces the other way
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    if (found.row(i).tail(3).dot(rows.row(i).tail(3)) < 0.0)
    {
      opposite.push_back(static_cast<int>(i));
    }
  }
  if (opposite.empty())
  {
    return inverse;
  }
  const TriangleTree tree(surface.Triangles(), moved);
  constexpr int grain = 256;
  ParallelFor(static_cast<int>(opposite.size()), grain,
    [&](int begin, int end)
    {
      for (int k = begin; k < end; ++k)
      {
        const int i = opposite[k];
        const NearestTriangle nearest = tree.Find(rows.row(i), 0);
        inverse.Triangles(i) = nearest.Triangle;
        inverse.Barycentrics.row(i) = nearest.Barycentric;
      }
    });
  return inverse;
}

} // namespace shape
