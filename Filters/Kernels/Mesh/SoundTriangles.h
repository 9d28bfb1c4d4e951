#pragma once

#include "Mesh/Topology.h"

#include <string>

namespace shape
{

class Surface;

/// Throws InvalidInput unless `surface` has triangles, each with three different points. Every
/// coordinate must be finite, and the longest edge of the bounding box must be between 1e-50 and
/// 1e50. `name` denotes the surface in the message. Returns the topology; RequireManifold requires
/// a manifold, too.
Topology RequireTriangles(const Surface& surface, const std::string& name);

} // namespace shape
