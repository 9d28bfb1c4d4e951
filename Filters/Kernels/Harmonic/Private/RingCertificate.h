#pragma once

#include "Base/Progress.h"
#include "Harmonic/ChargeSet.h"
#include "Harmonic/PiecewiseHarmonicMap.h"

#include <vector>

namespace shape
{

/**
 * Returns those of the given tetrahedra of a repair in which it is not proven that the repaired map
 * g = h + phi (f - h) has a positive Jacobian determinant, in ascending order.
 *
 * The method is that of CertifyMap. The tetrahedra are covered by cubes, and in each cube f is a
 * Taylor polynomial with a bound of the remainder e. The products with the linear function phi are
 * polynomials, too, and g leaves out phi e, whose derivative is at most
 *
 *   |phi| |grad e| + |grad phi| |e|.
 *
 * e vanishes at the centre of its polynomial, so |e| is at most the distance from there times the
 * bound of |grad e|. A cube is divided for the tetrahedra that it does not decide, until its edge
 * is 1/16 of theirs.
 *
 * tetrahedra: indices, ascending. The images and shares of their points must be set. Throws
 * Aborted.
 */
std::vector<int> FindUncertified(const ChargeSet& map, const MapRepair& repair,
  const std::vector<int>& tetrahedra, const Progress& progress = {});

} // namespace shape
