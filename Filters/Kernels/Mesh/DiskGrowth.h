#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Grows a disk over a surface from its first triangle: rows of triangles in rising order, each time
 * the first one is added that joins the disk such that it stays one, in O(m log m). Where the
 * surface closes around a limb or a hole the disk meets itself, and stays open along that line. All
 * triangles where they are a disk that can be put together like this; none of a surface without
 * triangles.
 *
 * triangles: m x 3 of `points` points, an oriented 2-manifold with or without border.
 */
std::vector<int> GrowDisk(const Eigen::MatrixXi& triangles, Eigen::Index points);

} // namespace shape
