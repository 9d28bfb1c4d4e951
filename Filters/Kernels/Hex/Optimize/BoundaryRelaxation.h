#pragma once

#include "Base/Progress.h"
#include "Hex/Features/FeatureConstraint.h"
#include "Mesh/HexMesh.h"

#include <functional>

namespace shape
{

/**
 * Turns hexahedra that stay inverted as long as all points keep to the surface, as in a groove that
 * surfaces make where they touch: points around them are freed of the surface, farther and farther
 * from them, a few rings of hexahedra at most, and moved (OptimizeHexahedra).
 *
 * mesh: its points are moved; if some stay inverted, none is. freedoms: become 3 for those that are
 * freed. Nothing is done where none is inverted. Throws Aborted.
 */
void RelaxBoundaryOfInverted(
  HexMesh& mesh, OverridableConstraint& freedoms, const Progress& progress = {});

/**
 * The same for hexahedra that are not inverted but whose scaled Jacobian is below `wanted`; points
 * on creases stay there. It goes on while `accepts` is true of the mesh, whose last such state is
 * kept, and the worst becomes better. Throws Aborted.
 */
void RelaxBoundaryOfWorst(HexMesh& mesh, OverridableConstraint& freedoms, double wanted,
  const std::function<bool(const HexMesh& mesh)>& accepts, const Progress& progress = {});

} // namespace shape
