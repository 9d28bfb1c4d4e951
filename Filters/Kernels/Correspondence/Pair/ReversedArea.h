#pragma once

#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

namespace shape
{

/// Returns the share of A's area that a map to B inverts, in [0, 1]. The weight of a triangle is
/// the smaller of its area and its image's area, both surfaces scaled to area 1, times |cosine| of
/// the angle between the normals of the image and of B. a, b: surfaces that both face outwards.
/// aToB: the image of each point of A.
double ComputeReversedArea(const Surface& a, const Surface& b, const SurfacePoints& aToB);

} // namespace shape
