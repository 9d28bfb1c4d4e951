#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

namespace shape
{

/**
 * Returns the inverse of a map between surfaces: for each point of `target`, the position on
 * `surface` whose image is nearest to it. If that is on an opposite sheet, such as an arm that
 * touches the body, distances are those of positions and, weighted by a 20th of the root of the
 * area, of normals. Images inside a triangle of `surface` are interpolated from those of its
 * corners, so the inverse is exact where the map is one to one and the target is flat, or its
 * points are images.
 *
 * images: of the points of `surface`, on triangles of `target`. Throws InvalidInput if a surface
 * has no triangle; Aborted.
 */
SurfacePoints InvertMap(const Surface& surface, const SurfacePoints& images, const Surface& target,
  const Progress& progress = {});

} // namespace shape
