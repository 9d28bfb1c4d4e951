#pragma once

#include "Mesh/Surface.h"

#include <unsupported/Eigen/BVH>

#include <memory>

namespace shape
{

/// A hierarchy of boxes, whose objects are numbers.
using BoxTree = Eigen::KdBVH<double, 3, int>;

/// The hierarchy of boxes around the triangles of a surface, built once and kept with it: every
/// search in the surface uses this one. surface: with triangles.
std::shared_ptr<const BoxTree> GetTriangleBoxes(const Surface& surface);

} // namespace shape
