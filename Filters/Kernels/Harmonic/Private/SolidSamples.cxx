#include "Harmonic/Private/SolidSamples.h"

#include "Geometry/HaltonSequence.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace shape
{

Eigen::MatrixXd SampleTetrahedra(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra, int count)
{
  Eigen::VectorXd volumes(tetrahedra.rows());
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
  {
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k)
    {
      edges.col(k) = points.row(tetrahedra(t, k + 1)) - points.row(tetrahedra(t, 0));
    }
    volumes(t) = std::abs(edges.determinant());
  }
  const double all = volumes.sum();
  Eigen::MatrixXd positions(count, 3);
  Eigen::Index t = 0;
  double until = volumes(0); // the volume of the tetrahedra up to the current one
  for (int i = 0; i < count; ++i)
  {
    const double wanted = all * (i + 0.5) / count;
    while (until < wanted && t + 1 < tetrahedra.rows())
    {
      until += volumes(++t);
    }
    // The gaps between sorted numbers in [0, 1] are barycentric coordinates, evenly distributed.
    std::array<double, 5> cuts = { 0.0, GetHaltonNumber(i + 1, 2), GetHaltonNumber(i + 1, 3),
      GetHaltonNumber(i + 1, 5), 1.0 };
    std::sort(cuts.begin(), cuts.end());
    positions.row(i).setZero();
    for (int k = 0; k < 4; ++k)
    {
      positions.row(i) += (cuts[k + 1] - cuts[k]) * points.row(tetrahedra(t, k));
    }
  }
  return positions;
}

} // namespace shape
