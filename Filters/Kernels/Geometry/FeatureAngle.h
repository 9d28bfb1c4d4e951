#pragma once

namespace shape
{

/// The default feature angle, in degrees, of every kernel and filter. An edge is a feature if the
/// angle between the normals of its two faces is larger.
inline constexpr double DefaultFeatureAngle = 40.0;

} // namespace shape
