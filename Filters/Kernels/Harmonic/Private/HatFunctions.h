#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace shape
{

/// The hat functions of the corners of a tetrahedron: linear, 1 at one corner, 0 at the others.
struct HatFunctions
{
  Eigen::Matrix<double, 4, 3> Gradients; ///< in rows
  double Volume;                         ///< of the tetrahedron; negative if it is inverted
};

/// points: n x 3. corners: indices of them.
HatFunctions ComputeHats(const Eigen::MatrixXd& points, const Eigen::RowVector4i& corners);

/// Returns the stiffness matrix (n x n) of tetrahedra (m x 4): the integrals of the products of the
/// hat functions' gradients. Off the diagonal these are the negative cotangent weights.
Eigen::SparseMatrix<double> BuildStiffness(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra);

} // namespace shape
