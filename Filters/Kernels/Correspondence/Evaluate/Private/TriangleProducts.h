#pragma once

#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Inner products of piecewise linear functions on triangles, exactly integrated.
struct TriangleProducts
{
  Eigen::MatrixXd Mass;      ///< k x k: the integrals of f g
  Eigen::MatrixXd Dirichlet; ///< k x k: the integrals of grad f . grad g
};

/// Computes the inner products of the columns of `functions` (n x k) in the metric of `surface`.
TriangleProducts ComputeTriangleProducts(const Surface& surface, const Eigen::MatrixXd& functions);

} // namespace shape
