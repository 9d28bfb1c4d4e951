#pragma once

#include "Core/Mesh.h"

#include <string>

// Surfaces that the kernel tests share.
namespace shapetest
{

/// The unit sphere: an icosahedron whose triangles are split into four `level` times.
/// 12, 42, 162, 642, 2562, 10242 points.
shape::Mesh Icosphere(int level);

/// A torus around the z axis, `around` x `across` quads in two triangles each.
shape::Mesh Torus(double majorRadius, double minorRadius, int around, int across);

/// A triangle mesh in OFF format. Throws std::runtime_error where the file cannot be read.
shape::Mesh ReadOff(const std::string& path);

} // namespace shapetest
