#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Untangle/MinimizeEnergy.h"

namespace shape
{

/**
 * Repairs inverted hexahedra (scaled Jacobian <= 0) by moving all points around them
 * simultaneously. This also succeeds where moving single points gives no improvement. Newton's
 * method lowers the regularised elliptic energy of the hexahedra's corners (MinimizeEnergy), in
 * patches that grow while hexahedra stay inverted. Each connected patch is solved separately. A
 * patch of more than 20,000 movable points is left unchanged.
 *
 * mesh: the hexahedra whose points are moved, within the constraint. steps: the maximum number of
 * Newton steps for each patch (HexOptimizationOptions). Returns the number of
 * hexahedra that stay inverted, which is never greater than before. Throws Aborted.
 */
int UntangleHexahedra(
  HexMesh& mesh, const PointConstraint& constraint, int steps, const Progress& progress = {});

} // namespace shape
