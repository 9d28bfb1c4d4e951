#pragma once

namespace shape
{

/// The angle between the normals of two faces, in degrees, above which their edge is a feature:
/// the default of every kernel and filter.
inline constexpr double DefaultFeatureAngle = 40.0;

} // namespace shape
