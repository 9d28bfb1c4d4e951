#pragma once

#include <Eigen/Core>

namespace shape
{

/// Returns positions (count x 3) that are evenly distributed over the volume of tetrahedra, at the
/// points of a Halton sequence in three dimensions. points: n x 3. tetrahedra: t x 4,
/// of positive volume in total.
Eigen::MatrixXd SampleTetrahedra(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra, int count);

} // namespace shape
