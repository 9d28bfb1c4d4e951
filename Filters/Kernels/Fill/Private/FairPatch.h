#pragma once

#include "Base/Progress.h"
#include "Fill/FairSurface.h"
#include "Fill/HolePatch.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

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

/// By how much a rim's normals lean outwards from the direction that it goes around: radians, in
/// the mean; 0 where they are those of the rim's plane, negative where they lean inwards.
double ComputeMeanTilt(const BoundaryLoop& loop);

/**
 * A start for SolveFairSurface that bulges: the part of a sphere that leaves a circle by the rim's
 * mean tilt, bent to the rim. The patch's layout, a disk in a circle around the origin, goes to the
 * sphere by stereographic projection, which keeps its triangles' shapes; what the rim differs from
 * the circle is spread by SolveHarmonicValues. Returns places of all points (n x 3).
 *
 * patch: as BuildMembranePatch makes it. The tilt is taken as 150 degrees at most.
 */
Eigen::MatrixXd BuildSphericalCap(const HolePatch& patch, const BoundaryLoop& loop);

} // namespace shape
