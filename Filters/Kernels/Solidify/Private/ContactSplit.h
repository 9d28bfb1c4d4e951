#pragma once

#include "Base/Progress.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Mesh.h"
#include "Mesh/Provenance.h"

#include <vector>

namespace shape
{

/// A surface whose triangles meet others only along their edges, up to rounding.
struct SplitContacts
{
  Mesh Surface;                 ///< the points of the given surface come first
  shape::Provenance Provenance; ///< from the given surface
};

/// Splits the triangles of a surface where they meet others (FindTriangleContacts, SplitTriangle).
/// The parts of a triangle have its orientation; the others are not changed. Positions at which
/// three triangles meet are rounded in each of them, so they must be joined afterwards. pairs:
/// FindSelfIntersections. Throws SolveFailure if a triangle cannot be split; Aborted.
SplitContacts SplitAtContacts(
  const Mesh& surface, const std::vector<Crossing>& pairs, const Progress& progress);

} // namespace shape
