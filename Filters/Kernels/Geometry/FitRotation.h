#pragma once

#include <Eigen/Core>

namespace shape
{

/**
 * The rotation nearest to a matrix, in the Frobenius norm (Kabsch, "A solution for the best
 * rotation to relate two sets of vectors", 1976). With the matrix sum_j to_j from_j^T it is the
 * rotation R with the minimum of sum_j |R from_j - to_j|^2. A matrix whose second singular value is
 * 0 has several such rotations; one of them is returned.
 */
Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix);

/// The same, of a matrix with the singular vectors u and v (in columns, by falling singular value).
Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& u, const Eigen::Matrix3d& v);

} // namespace shape
