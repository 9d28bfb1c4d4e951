#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Untangle/MinimizeEnergy.h"

namespace shape
{

/**
 * Repairs inverted hexahedra, those with a scaled Jacobian <= 0, by moving all points around them
 * simultaneously. Newton's method lowers the regularised elliptic energy of their corners
 * (MinimizeEnergy), in patches that grow while some stay inverted. Each connected patch is solved
 * separately; a patch of more than 20,000 points is left unchanged. This escapes from positions
 * that no motion of a single point improves.
 *
 * mesh: its points are moved within the constraint; the number of inverted hexahedra never grows.
 * Returns that number. Throws Aborted.
 */
int UntangleHexahedra(
  HexMesh& mesh, const PointConstraint& constraint, const Progress& progress = {});

} // namespace shape
