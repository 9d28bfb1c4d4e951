#pragma once

#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <string>

namespace shape
{

// What methods that match two surfaces ask of them. `name` is what messages call one: "surface A".

/// Throws InvalidInput unless the surface has an area.
void RequireArea(const Surface& surface, const std::string& name);

/// Throws InvalidInput unless the surface is a consistently oriented 2-manifold with an area, open
/// or closed, and a triangle at each point.
Topology RequireWhole(const Surface& surface, const std::string& name);

/// The same, and of one component.
Topology RequireConnected(const Surface& surface, const std::string& name);

/// Throws InvalidInput unless landmarks are points of surfaces A and B.
void RequireLandmarks(const Landmarks& landmarks, const Surface& a, const Surface& b);

/// The landmarks' points of A (which = 0) or B (1).
std::vector<int> PointsOf(const Landmarks& landmarks, int which);

} // namespace shape
