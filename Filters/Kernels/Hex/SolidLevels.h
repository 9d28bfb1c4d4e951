#pragma once

#include "Core/Progress.h"
#include "Geometry/ClosestPoint.h"
#include "Geometry/IsoSurface.h"

namespace shape
{

/// How far from the surface, in cells, levels still are distances.
inline constexpr double LevelBand = 2.0;

/**
 * A grid of cubic cells around a solid: at the centre of each the signed distance to the solid's
 * boundary, negative inside, where it is nearer than LevelBand cells; LevelBand cells elsewhere.
 * The solid is what `surface` winds around at least once; the grid's outermost cells lie outside.
 *
 * surface: closed, oriented consistently, facing outwards; it may cross itself. boundary: what of
 * it bounds the solid (SolidBoundary). size: of a cell, > 0. Throws InvalidInput where the grid has
 * more than 2e8 cells, Aborted.
 */
SampledGrid SolidLevels(
  const Mesh& surface, const SurfaceLocator& boundary, double size, const Progress& progress = {});

} // namespace shape
