#include "Correspondence/Evaluate/Private/TriangleProducts.h"

#include "Laplacian/CotangentWeights.h"

#include <vector>

namespace shape
{

TriangleProducts ComputeTriangleProducts(const Surface& surface, const Eigen::MatrixXd& functions)
{
  const TriangleAngles angles = ComputeTriangleAngles(surface);
  const Eigen::MatrixXi& triangles = surface.Triangles();
  const Eigen::Index points = surface.Points().rows();
  // The integral of two hat functions is a twelfth of the area; of a hat function squared, a sixth.
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(9 * triangles.rows());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int a = 0; a < 3; ++a)
    {
      for (int b = 0; b < 3; ++b)
      {
        entries.emplace_back(
          triangles(t, a), triangles(t, b), angles.Areas(t) * (a == b ? 2.0 : 1.0) / 12.0);
      }
    }
  }
  Eigen::SparseMatrix<double> masses(points, points);
  masses.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> stiffness =
    BuildCotangentStiffness(triangles, angles.Cotangents, points);
  return { functions.transpose() * (masses * functions),
    functions.transpose() * (stiffness * functions) };
}

} // namespace shape
