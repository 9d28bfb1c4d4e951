#pragma once

#include "Mesh/Mesh.h"

#include <string>
#include <vector>

// Surfaces that the kernel tests share.
namespace shapetest
{

/// The unit sphere: an icosahedron whose triangles are split into four `level` times.
/// 12, 42, 162, 642, 2562, 10242 points.
shape::Mesh Icosphere(int level);

/// A torus around the z axis, `around` x `across` quads in two triangles each.
shape::Mesh Torus(double majorRadius, double minorRadius, int around, int across);

/// The unit disk in z = 0 as rings of 6, 12, 18, ... points around the middle; the outer one last,
/// from (1, 0) on.
shape::Mesh FlatDisk(int rings);

/// [-1, 1] x [-1, 1] in cells x cells quads of two triangles each, whose diagonals leave no corner
/// alone; inner points moved by up to `shake` cells.
shape::Mesh FlatSquare(int cells, double shake);

/// A prism over a polygon in the plane z = 0, 1 high, its polygons as fans around point 0.
shape::Mesh Prism(const std::vector<Eigen::RowVector2d>& outline);

/// A triangle mesh in OFF format. Throws std::runtime_error where the file cannot be read.
shape::Mesh ReadOff(const std::string& path);

} // namespace shapetest
