#pragma once

#include "Mesh/Mesh.h"
#include "Base/Progress.h"
#include "Fill/FairSurface.h"
#include "Fill/HolePatch.h"

namespace shape
{

struct FairPatchResult
{
  Mesh Patch;             ///< the rim's points first
  bool Converged = false; ///< see FairSurfaceResult
  bool IsBalloon = false; ///< its area is more than ten times the membrane's: given up
};

/**
 * The fair surface of a rim (FairSurface) with triangles of its own: where it bulges those of a
 * membrane would be stretched. A large hole is filled coarsely first, from a biharmonic surface, or
 * where the normals lean far from a part of a sphere; and is retriangulated until the triangles
 * stay even. Then as fine as wanted, which takes few iterations.
 *
 * membrane: as MembranePatch makes it of the rim. Throws SolveFailure, Aborted.
 */
FairPatchResult FairPatch(const HolePatch& membrane, const SurfaceRim& rim, const PatchSizes& sizes,
  const Progress& progress = {});

} // namespace shape
