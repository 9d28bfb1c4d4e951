#pragma once

#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <string>

namespace shape
{

// The requirements of methods that match two surfaces. `name` is the surface's name in messages,
// such as "surface A".

/// Throws InvalidInput unless the surface has a positive, finite area.
void RequireArea(const Surface& surface, const std::string& name);

/// Throws InvalidInput unless the surface is a consistently oriented 2-manifold, open or closed,
/// with a positive area and a triangle at each point. Returns its topology.
Topology RequireWhole(const Surface& surface, const std::string& name);

/// Throws InvalidInput when RequireWhole does, or if the surface has several components.
Topology RequireConnected(const Surface& surface, const std::string& name);

/// Returns the genus, the number of handles. If there are several components, it is the sum of
/// theirs. Boundary loops count as filled.
int ComputeGenus(const Topology& topology);

/// Throws InvalidInput unless the landmarks are points of surfaces A and B.
void RequireLandmarks(const Landmarks& landmarks, const Surface& a, const Surface& b);

/// Returns the landmarks' points of A (which = 0) or of B (which = 1).
std::vector<int> PointsOf(const Landmarks& landmarks, int which);

} // namespace shape
