#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Grows a disk over a surface from its first triangle, in O(m log m). Each step adds one triangle,
 * so that the disk remains a disk. If several triangles are possible, the one with the lowest index
 * is added. Where the disk meets itself, for example behind a hole or around a cylindrical part, it
 * stays open along a line.
 *
 * triangles: m x 3, an oriented 2-manifold with or without boundary. points: the number of points.
 * Returns the indices of the disk's triangles, ascending. These are all triangles if the surface is
 * a disk that can be grown this way. The result is empty if there are no triangles.
 */
std::vector<int> GrowDisk(const Eigen::MatrixXi& triangles, Eigen::Index points);

} // namespace shape
