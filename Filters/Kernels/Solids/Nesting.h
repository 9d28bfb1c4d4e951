#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <string>

namespace shape
{

/**
 * Orients the surface of a solid with voids so that it faces out of the solid.
 *
 * Each component of a closed surface bounds the solid from outside, or a void in it, or a solid in
 * that void, and so on. A component inside an even number of others is oriented outwards, one
 * inside an odd number inwards, whatever their orientation before. The winding number at one of its
 * points decides which components are around a component (Mesh/Mesh.h). Exact orientations decide
 * whether two meet (Geometry/SelfIntersections.h).
 *
 * surface: as for RequireClosedSurface; `name` is used for it in messages. If every component is
 * already oriented correctly, the result is the same surface, with its cached data. The result is
 * cached in `surface`. Throws InvalidInput if the surface is not closed, or if two components touch
 * or cross, so that neither lies within the other; Aborted. A component that touches itself is not
 * detected.
 */
Surface OrientByNesting(
  const Surface& surface, const std::string& name, const Progress& progress = {});

} // namespace shape
