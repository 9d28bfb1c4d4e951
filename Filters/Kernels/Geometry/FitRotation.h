#pragma once

#include <Eigen/Core>

namespace shape
{

/// Returns the rotation nearest to a matrix. It is the orthogonal polar factor of the matrix,
/// unless this factor is a reflection. For the matrix sum_j to_j from_j^T it is the rotation R that
/// minimises the sum of |R from_j - to_j|^2 (Kabsch 1976).
Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix);

/// The same, for a matrix that may not determine the rotation. If the matrix is zero, the result is
/// `estimate`. If it has rank one, u v^T, the result is `estimate`, followed by the smallest
/// rotation that takes the estimated image of v to the direction of u.
Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix, const Eigen::Matrix3d& estimate);

/// Returns FitRotation(mean) for a mean of rotations, with an error of at most 1e-9. It is ten
/// times as fast as FitRotation if the rotations do not differ too much.
Eigen::Matrix3d FitBlendedRotation(const Eigen::Matrix3d& mean);

} // namespace shape
