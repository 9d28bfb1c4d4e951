#pragma once

#include <Eigen/Core>

namespace shape
{

/// The rotation nearest to a matrix: its orthogonal polar factor or, if that mirrors, the nearest
/// rotation. Of sum_j to_j from_j^T, it is the rotation R that minimises the sum of |R from_j -
/// to_j|^2 (Kabsch 1976).
Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix);

/// The same for a matrix that may not determine the rotation, given an estimate of it: if the
/// matrix has rank one, the estimate followed by the least rotation that takes its direction where
/// the matrix does; if it is zero, the estimate.
Eigen::Matrix3d FitRotation(const Eigen::Matrix3d& matrix, const Eigen::Matrix3d& estimate);

/// FitRotation of a mean of rotations, to 1e-9: ten times as fast if these are not too different.
Eigen::Matrix3d FitBlendedRotation(const Eigen::Matrix3d& mean);

} // namespace shape
