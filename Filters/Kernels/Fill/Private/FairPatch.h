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
  Mesh Patch;             ///< the loop's points first
  bool Converged = false; ///< see FairSurfaceResult
  bool IsBalloon = false; ///< its area is more than ten times the membrane's: given up
};

/**
 * The fair surface of a loop (SolveFairSurface) with triangles of its own: on a bulge, those of a
 * membrane would be stretched. A large hole is first filled coarsely, from a biharmonic surface or,
 * if the normals are tilted far, from a spherical cap; it is remeshed until the triangles stay
 * even. Then it is remeshed to the wanted size, which takes few iterations.
 *
 * membrane: of the loop (BuildMembranePatch). Throws SolveFailure, Aborted.
 */
FairPatchResult BuildFairPatch(const HolePatch& membrane, const BoundaryLoop& loop,
  const PatchSizes& sizes, const Progress& progress = {});

/// The mean angle in radians by which a loop's normals are tilted outwards from its area vector: 0
/// if they are the normal of the loop's plane, negative if they are tilted inwards.
double ComputeMeanTilt(const BoundaryLoop& loop);

/**
 * An initial surface for SolveFairSurface that bulges: the spherical cap that leaves a circle by
 * the loop's mean tilt, bent to the loop. The patch's layout, a disk in a circle around the origin,
 * goes to the sphere by stereographic projection, which is conformal; the difference between loop
 * and circle is interpolated by SolveHarmonicValues. Returns the positions of all points (n x 3).
 *
 * patch: as BuildMembranePatch makes it. The tilt is limited to 150 degrees.
 */
Eigen::MatrixXd BuildSphericalCap(const HolePatch& patch, const BoundaryLoop& loop);

} // namespace shape
