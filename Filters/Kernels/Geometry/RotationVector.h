#pragma once

#include <Eigen/Core>

namespace shape
{

/// Returns the rotation about a rotation vector: its direction is the axis, its length the angle in
/// radians. The zero vector gives the identity.
Eigen::Matrix3d ToRotation(const Eigen::Vector3d& vector);

} // namespace shape
