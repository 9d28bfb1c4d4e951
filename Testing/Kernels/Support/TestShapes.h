#pragma once

#include "Mesh/Mesh.h"

#include <string>
#include <vector>

// Surfaces shared by the kernel tests.
namespace shapetest
{

/// Returns the unit sphere: an icosahedron whose triangles are split into four `level` times. It
/// has 12, 42, 162, 642, 2562, 10242 points for levels 0 to 5.
shape::Mesh Icosphere(int level);

/// Returns a torus around the z axis with `around` x `across` quads of two triangles each.
shape::Mesh Torus(double majorRadius, double minorRadius, int around, int across);

/// Returns the unit disk in z = 0 as rings of 6, 12, 18, ... points around the middle. The outer
/// ring is last and starts at (1, 0).
shape::Mesh FlatDisk(int rings);

/// Returns [-1, 1] x [-1, 1] as cells x cells quads of two triangles each. Each corner of the
/// square belongs to two triangles. Inner points are moved by up to `shake` cells.
shape::Mesh FlatSquare(int cells, double shake);

/// Returns a prism of height 1 over a polygon in the plane z = 0. Its polygons are fans around
/// point 0.
shape::Mesh Prism(const std::vector<Eigen::RowVector2d>& outline);

/// Reads a triangle mesh in OFF format. Throws std::runtime_error if the file cannot be read.
shape::Mesh ReadOff(const std::string& path);

/// Reads `name`.off of build/models. Throws as ReadOff does.
shape::Mesh ReadModel(const std::string& name);

} // namespace shapetest
