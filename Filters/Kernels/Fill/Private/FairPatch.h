#pragma once

#include "Base/Progress.h"
#include "Fill/FairSurface.h"
#include "Fill/HolePatch.h"
#include "Mesh/Mesh.h"

namespace shape
{

struct FairPatchResult
{
  Mesh Patch;             ///< the rim's points first
  bool Converged = false; ///< see FairSurfaceResult
  bool IsBalloon = false; ///< its area is more than ten times the membrane's: given up
};

/**
 * The fair surface of a rim (SolveFairSurface) with triangles of its own: where it bulges those of
 * a membrane would be stretched. A large hole is filled coarsely first, from a biharmonic surface,
 * or where the normals lean far from a part of a sphere; and is retriangulated until the triangles
 * stay even. Then as fine as wanted, which takes few iterations.
 *
 * membrane: as BuildMembranePatch makes it of the rim. Throws SolveFailure, Aborted.
 */
FairPatchResult BuildFairPatch(const HolePatch& membrane, const BoundaryLoop& loop,
  const PatchSizes& sizes, const Progress& progress = {});

} // namespace shape
