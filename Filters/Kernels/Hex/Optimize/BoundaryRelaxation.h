#pragma once

#include "Base/Progress.h"
#include "Hex/Features/FeatureConstraint.h"
#include "Mesh/HexMesh.h"

#include <functional>

namespace shape
{

/**
 * Repairs hexahedra that stay inverted as long as all points keep to the surface, as in a groove
 * between two touching parts. Points around them are released from the surface and moved
 * (OptimizeHexahedra), in a neighbourhood that grows to a few rings of hexahedra at most.
 *
 * mesh: its points are moved; if a hexahedron stays inverted, they are all restored. freedoms:
 * become 3 for the released points. Does nothing if no hexahedron is inverted. Throws Aborted.
 */
void RelaxBoundaryOfInverted(
  HexMesh& mesh, OverridableConstraint& freedoms, const Progress& progress = {});

/**
 * Does the same for hexahedra that are not inverted but have a scaled Jacobian below `wanted`;
 * points on creases stay there. A round is undone if it does not improve the worst scaled Jacobian,
 * or if `accepts` returns false for the mesh. Throws Aborted.
 */
void RelaxBoundaryOfWorst(HexMesh& mesh, OverridableConstraint& freedoms, double wanted,
  const std::function<bool(const HexMesh& mesh)>& accepts, const Progress& progress = {});

} // namespace shape
