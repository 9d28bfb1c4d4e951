#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Grows a disk over a surface from its first triangle, in O(m log m). Each step adds the triangle
 * of lowest index that can join the disk and leaves it a disk. Where the surface closes around a
 * cylindrical part or a hole, the disk meets itself and stays open along that line.
 *
 * triangles: m x 3 indices of `points` points, an oriented 2-manifold with or without boundary.
 * Returns the indices of the disk's triangles, ascending: all of them if the surface is a disk that
 * can be grown this way, none if there are no triangles.
 */
std::vector<int> GrowDisk(const Eigen::MatrixXi& triangles, Eigen::Index points);

} // namespace shape
