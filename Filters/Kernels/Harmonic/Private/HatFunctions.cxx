#include "Harmonic/Private/HatFunctions.h"

#include "Base/Parallel.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <vector>

namespace shape
{

HatFunctions ComputeHats(const Eigen::MatrixXd& points, const Eigen::RowVector4i& corners)
{
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k)
  {
    edges.row(k) = points.row(corners(k + 1)) - points.row(corners(0));
  }
  HatFunctions hats;
  hats.Volume = edges.determinant() / 6.0;
  hats.Gradients.bottomRows<3>() = edges.inverse().transpose();
  hats.Gradients.row(0) = -hats.Gradients.bottomRows<3>().colwise().sum();
  return hats;
}

Eigen::SparseMatrix<double> BuildStiffness(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra)
{
  std::vector<Eigen::Triplet<double>> entries(16 * tetrahedra.rows());
  ParallelFor(static_cast<int>(tetrahedra.rows()), 10000,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        const HatFunctions hats = ComputeHats(points, tetrahedra.row(t));
        const Eigen::Matrix4d products = hats.Volume * hats.Gradients * hats.Gradients.transpose();
        for (int i = 0; i < 4; ++i)
        {
          for (int k = 0; k < 4; ++k)
          {
            entries[16 * static_cast<std::size_t>(t) + 4 * i + k] = { tetrahedra(t, i),
              tetrahedra(t, k), products(i, k) };
          }
        }
      }
    });
  Eigen::SparseMatrix<double> stiffness(points.rows(), points.rows());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

} // namespace shape
