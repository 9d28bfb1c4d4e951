#pragma once

#include "Base/Progress.h"
#include "Hex/Features/FeatureConstraint.h"
#include "Mesh/HexMesh.h"

#include <functional>

namespace shape
{

/**
 * Repairs hexahedra that cannot become positive while all boundary points stay on the surface, for
 * example in a groove between two touching parts. Points of hexahedra with a scaled Jacobian below
 * 0.2 are released from the surface and moved (OptimizeHexahedra). Each further round also releases
 * the points of one more ring of hexahedra around them. Points on creases and corners are released
 * only if a hexahedron stays inverted otherwise.
 *
 * mesh: the hexahedra whose points are moved. freedoms: the freedom of released points becomes 3.
 * If a hexahedron stays inverted, all points and freedoms are restored. Does nothing if no
 * hexahedron is inverted. Throws Aborted.
 */
void RelaxBoundaryOfInverted(
  HexMesh& mesh, OverridableConstraint& freedoms, const Progress& progress = {});

/**
 * Releases and moves points around hexahedra with a scaled Jacobian below `wanted`, in rounds with
 * growing neighbourhoods. Points on creases are not released. A round is undone if it does not
 * raise the minimum scaled Jacobian, or if `accepts` returns false for the mesh. Throws Aborted.
 */
void RelaxBoundaryOfWorst(HexMesh& mesh, OverridableConstraint& freedoms, double wanted,
  const std::function<bool(const HexMesh& mesh)>& accepts, const Progress& progress = {});

} // namespace shape
