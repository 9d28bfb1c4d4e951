#pragma once

#include "Base/Progress.h"
#include "Harmonic/ChargeSet.h"
#include "Harmonic/PiecewiseHarmonicMap.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Replaces a harmonic map everywhere: the solid is filled with tetrahedra as large as its boundary
 * permits, and their inner points move until none is inverted (UntanglePart). There are far fewer
 * than in a core of RepairMap, so that they can be untangled where those cannot. The map is linear
 * in each, and less smooth.
 *
 * domain: closed, facing out of the solid. images: n x 3, of its points. Returns a repair without
 * tetrahedra if some stay inverted, or if TetGen does not fill the solid. Throws what UntanglePart
 * throws.
 */
MapRepair RepairWhole(const ChargeSet& map, const Surface& domain, const Eigen::MatrixXd& images,
  const Progress& progress);

} // namespace shape
