#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <string>

namespace shape
{

/// Returns the bounding box of the points that triangles use. If there are no triangles, it is the
/// box of all points.
Eigen::AlignedBox3d ComputeBox(const Mesh& mesh);

/// Returns the longest edge of ComputeBox. A point that no triangle uses does not change a length
/// that is relative to the size of a surface.
double ComputeLongestBoxEdge(const Mesh& mesh);

/// Returns the diagonal of ComputeBox.
double ComputeBoxDiagonal(const Mesh& mesh);

/// Returns the mean length of the edges of the triangles. An edge of two triangles counts twice.
double ComputeMeanEdgeLength(const Mesh& mesh);

/**
 * Throws InvalidInput if lengths cannot be computed with in double precision. The longest edge of
 * the points' bounding box must be 0 or between 1e-50 and 1e50; sixth powers of lengths then
 * neither overflow nor underflow. It must also be at least 1e-13 of the largest coordinate; nearer
 * to the origin, rounding leaves the shape. `name` denotes the points in the message, for example
 * "the surface".
 */
void RequireExtent(const Eigen::MatrixXd& points, const std::string& name);

/// The same for the points that triangles use.
void RequireExtent(const Mesh& mesh, const std::string& name);

} // namespace shape
