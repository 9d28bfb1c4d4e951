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
  /// Whether the search was given up because the area exceeds ten times the membrane's.
  bool IsBalloon = false;
};

/**
 * Builds the fair surface of a loop (SolveFairSurface) with a new triangulation, since the
 * triangles of a membrane would be stretched on a bulge. A large hole is first filled coarsely. The
 * initial surface is biharmonic or, if the normals are tilted far, a spherical cap. Then the
 * surface is remeshed and made fair until the triangles stay even. Finally it is remeshed to the
 * wanted size, which takes few iterations.
 *
 * membrane: the membrane of the loop (BuildMembranePatch). Throws SolveFailure, Aborted.
 */
FairPatchResult BuildFairPatch(const HolePatch& membrane, const BoundaryLoop& loop,
  const PatchSizes& sizes, const Progress& progress = {});

/// Returns the mean angle in radians by which a loop's normals are tilted outwards from its area
/// vector. It is 0 if the normals agree with the normal of the loop's plane, and negative if they
/// are tilted inwards.
double ComputeMeanTilt(const BoundaryLoop& loop);

/**
 * Builds a bulging initial surface for SolveFairSurface: the spherical cap that leaves a circle at
 * the loop's mean tilt, deformed to fit the loop. The patch's layout, a disk in a circle around the
 * origin, is mapped to the sphere by stereographic projection, which is conformal.
 * SolveHarmonicValues interpolates the difference between loop and circle. Returns the positions of
 * all points (n x 3).
 *
 * patch: as BuildMembranePatch builds it. The tilt is limited to 150 degrees.
 */
Eigen::MatrixXd BuildSphericalCap(const HolePatch& patch, const BoundaryLoop& loop);

} // namespace shape
