#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Computes, for each point of a polyhedral surface, the length of the shortest path to the nearest
 * of `seeds`. The lengths are exact up to rounding.
 *
 * A window is an interval of an edge that is visible from one source position through unfolded
 * triangles. Windows are propagated across triangles in the order of their distance (Mitchell,
 * Mount and Papadimitriou, "The discrete geodesic problem", 1987). If a corner is visible from
 * several windows, only the nearest window continues on both sides of the corner. A window is
 * dropped if a path through an end of its edge is shorter (Chen and Han 1990, improved by Xin and
 * Wang, "Improving Chen and Han's algorithm on the discrete geodesic problem", 2009). Paths may
 * turn at points with a total angle of more than 2 pi and on the boundary.
 *
 * surface: a consistently oriented 2-manifold, open or closed. seeds: positions on its triangles,
 * at least one. Returns n distances in the model's units, infinite if there is no path. Points that
 * edges of length 0 join have the same distance. Throws SolveFailure if triangles are too thin for
 * double precision; Aborted.
 */
Eigen::VectorXd ComputeExactGeodesics(
  const Surface& surface, const ClosestPoints& seeds, const Progress& progress = {});

/**
 * Computes the length of the shortest path between each of n pairs of positions, exact up to
 * rounding. Returns n lengths, infinite if there is no path. The time for a pair grows with the
 * part of the surface that its path could cross. Throws SolveFailure if triangles are too thin for
 * double precision; Aborted.
 */
Eigen::VectorXd ComputeExactGeodesicsBetween(const Surface& surface, const SurfacePoints& from,
  const SurfacePoints& to, const Progress& progress = {});

} // namespace shape
