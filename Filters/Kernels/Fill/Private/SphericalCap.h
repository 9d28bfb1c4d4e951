#pragma once

#include "Fill/FairSurface.h"
#include "Fill/HolePatch.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

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
