#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <string>

namespace shape
{

/**
 * Orients the surface of a solid with voids so that it faces out of the solid.
 *
 * Each component of a closed surface is the outside of the solid, or bounds a void in the solid, or
 * a solid in this void, and so on. A component inside an even number of other components is
 * oriented outwards. A component inside an odd number of them is oriented inwards. The previous
 * orientations do not matter. Winding numbers around one point of a component decide which other
 * components are around it (Mesh/Mesh.h). Exact orientations decide whether two components meet
 * (Geometry/SelfIntersections.h).
 *
 * surface: see RequireClosedSurface; `name` denotes it in messages. If every component is already
 * oriented correctly, the result is the same surface, with its cached data. The result is cached in
 * `surface`. Throws InvalidInput if the surface is not closed, or if two components touch or cross;
 * Aborted. A component that touches itself is not detected.
 */
Surface OrientByNesting(
  const Surface& surface, const std::string& name, const Progress& progress = {});

} // namespace shape
