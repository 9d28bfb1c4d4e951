#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace shape
{

/// Whether a tetrahedron with these corners (rows, in either orientation) may have a point in a
/// box: false only if the box or the plane of one of its faces separates them by more than
/// rounding.
bool MayMeet(const Eigen::Matrix<double, 4, 3>& corners, const Eigen::AlignedBox3d& box);

} // namespace shape
