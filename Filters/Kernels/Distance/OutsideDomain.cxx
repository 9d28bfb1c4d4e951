#include "Distance/OutsideDomain.h"

#include <algorithm>

namespace shape
{

Eigen::VectorXd ComputeDomainTolerances(
  const Mesh& surface, const ClosestPoints& closest, double farthest)
{
  const double minimum = 1e-6 * ComputeLongestBoxEdge(surface.Points);
  Eigen::VectorXd tolerances(closest.Triangles.size());
  for (Eigen::Index i = 0; i < tolerances.size(); ++i)
  {
    const int t = closest.Triangles(i);
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest,
        (surface.Points.row(surface.Triangles(t, k)) -
          surface.Points.row(surface.Triangles(t, (k + 1) % 3)))
          .norm());
    }
    tolerances(i) = std::max(minimum, std::min(farthest, 0.25 * longest));
  }
  return tolerances;
}

Eigen::VectorXi FindPointsOutsideDomain(const SignedDistance& boundary,
  const Eigen::MatrixXd& points, double farthest, const Progress& progress)
{
  const SignedDistance::Result at = boundary.Evaluate(points, progress);
  const Eigen::VectorXd tolerances =
    ComputeDomainTolerances(boundary.Locator().GetSurface(), at.Closest, farthest);
  return (at.Distances.array() > tolerances.array()).cast<int>();
}

} // namespace shape
