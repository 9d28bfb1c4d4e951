#pragma once

#include "Mesh/Surface.h"

#include <unsupported/Eigen/BVH>

#include <memory>

namespace shape
{

/// A hierarchy of bounding boxes around objects, which are given by their indices.
using BoxTree = Eigen::KdBVH<double, 3, int>;

/// Returns the hierarchy of bounding boxes around the triangles of a surface. It is built once and
/// cached in the surface, for all searches. surface: with at least one triangle.
std::shared_ptr<const BoxTree> GetTriangleBoxes(const Surface& surface);

} // namespace shape
