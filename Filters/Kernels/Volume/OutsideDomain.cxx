#include "Volume/OutsideDomain.h"

#include <algorithm>

namespace shape
{

Eigen::VectorXi OutsideDomain(const SignedDistance& boundary, const Eigen::MatrixXd& points,
  double farthest, const Progress& progress)
{
  const Mesh& surface = boundary.Locator().Surface();
  const double least = 1e-6 * LongestSide(surface.Points);
  const SignedDistance::Result at = boundary.Evaluate(points, progress);
  Eigen::VectorXi outside(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const int t = at.Closest.Triangles(i);
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest,
        (surface.Points.row(surface.Triangles(t, k)) -
          surface.Points.row(surface.Triangles(t, (k + 1) % 3)))
          .norm());
    }
    outside(i) = at.Distances(i) > std::max(least, std::min(farthest, 0.25 * longest));
  }
  return outside;
}

} // namespace shape
