#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Untangle/MinimizeEnergy.h"

namespace shape
{

/**
 * Turns inverted hexahedra, those with a scaled Jacobian of 0 or less, by moving all points around
 * them at once: the regularised elliptic energy of their corners is lowered by Newton's method
 * (MinimizeEnergy), in patches that grow while some stay inverted, each connected piece of
 * hexahedra by itself; one of more than 20,000 points is left as it is. It gets out of
 * positions where no point alone can be moved for the better.
 *
 * mesh: its points are moved, as the constraint allows; it never has more inverted hexahedra after
 * than before. Returns how many there are. Throws Aborted.
 */
int UntangleHexahedra(
  HexMesh& mesh, const PointConstraint& constraint, const Progress& progress = {});

} // namespace shape
