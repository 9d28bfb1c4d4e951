#pragma once

#include <Eigen/Core>

namespace shape
{

/// Returns the rotation nearest to a matrix: its orthogonal polar factor or, if that is a
/// reflection, the nearest rotation. For the matrix sum_j to_j from_j^T it is the rotation R that
/// minimises the sum of |R from_j - to_j|^2 (Kabsch 1976).
Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix);

/// The same for a matrix that may not determine the rotation, with an estimate of it. If the matrix
/// has rank one, the result is the estimate followed by the smallest rotation that takes its
/// direction to where the matrix takes it. If the matrix is zero, the result is the estimate.
Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix, const Eigen::Matrix3d& estimate);

/// FitRotation of a mean of rotations, to 1e-9; ten times as fast if they do not differ too much.
Eigen::Matrix3d FitBlendedRotation(const Eigen::Matrix3d& mean);

} // namespace shape
