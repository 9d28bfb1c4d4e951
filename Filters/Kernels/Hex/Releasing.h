#pragma once

#include "Core/HexMesh.h"
#include "Core/Progress.h"
#include "Volume/SimplexPatch.h"

namespace shape
{

/**
 * Turns hexahedra that stay inverted as long as all points keep to the surface, as in a groove that
 * surfaces make where they touch: points around them are freed of the surface, farther and farther
 * from them, a few rings of hexahedra at most, and moved (OptimizeHexahedra).
 *
 * mesh: its points are moved; if some stay inverted, none is. Returns how many points were freed of
 * the constraint: 0 where none was inverted, or it does not help. Throws Aborted.
 */
int ReleaseInverted(
  HexMesh& mesh, const PointConstraint& constraint, const Progress& progress = {});

} // namespace shape
