#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

namespace shape
{

/**
 * The length of the shortest path on a polyhedral surface from the nearest of `seeds` to each of
 * its points, exact but for rounding.
 *
 * Windows, intervals of edges that are seen from one position through the triangles unfolded
 * between, are carried across triangles in the order of their distance (Mitchell, Mount and
 * Papadimitriou, "The discrete geodesic problem", 1987). A corner lets only the nearest of the
 * windows that see it continue on both of its sides, and what is farther than a path by way of an
 * edge's end is dropped (Chen and Han 1990 as improved by Xin and Wang, "Improving Chen and Han's
 * algorithm on the discrete geodesic problem", 2009). Paths may turn at points with an angle of
 * more than 2 pi and on the boundary.
 *
 * surface: a consistently oriented 2-manifold, open or closed. seeds: positions on its triangles,
 * at least one. Returns n distances in the model's units; infinite if no path leads there. Throws
 * Aborted.
 */
Eigen::VectorXd ComputeExactGeodesics(
  const Surface& surface, const ClosestPoints& seeds, const Progress& progress = {});

/**
 * The length of the shortest path between each of n pairs of positions (n), exact as above;
 * infinite if there is none. A pair takes the longer the more of the surface its path could lead
 * through. Throws Aborted.
 */
Eigen::VectorXd ComputeExactGeodesicsBetween(const Surface& surface, const SurfacePoints& from,
  const SurfacePoints& to, const Progress& progress = {});

} // namespace shape
