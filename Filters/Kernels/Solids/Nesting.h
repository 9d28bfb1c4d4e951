#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <string>

namespace shape
{

/**
 * The surface of a solid with voids, facing out of the solid: the given one itself if it does.
 *
 * Each component of a closed surface bounds the solid from outside, or a void in it, or a solid in
 * that void, and so on: a component that lies within an even number of others is turned to face
 * outwards, one within an odd number to face inwards. It does not matter how they face before.
 * Where a component lies is found by the winding number at one of its points (Mesh/Mesh.h), and
 * whether two meet by exact orientations (Geometry/Crossings.h).
 *
 * surface: as for RequireClosedSurface; `name` is what errors call it. Throws InvalidInput where it
 * is not closed, or where two components touch or cross, so that neither lies within the other;
 * Aborted. A component that touches itself is not noticed.
 */
Surface OrientByNesting(
  const Surface& surface, const std::string& name, const Progress& progress = {});

} // namespace shape
