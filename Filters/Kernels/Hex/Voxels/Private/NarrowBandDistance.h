#pragma once

#include "Base/Progress.h"
#include "Search/ClosestPoint.h"
#include "Solids/IsoSurface.h"

namespace shape
{

/// How far from the surface, in cells, levels still are distances.
inline constexpr double LevelBand = 2.0;

/// A grid of cubic cells around points (n x 3), without values; its outermost cells lie outside of
/// their box. size: of a cell, > 0. Throws InvalidInput where it has more than 2e8 cells.
SampledGrid BuildGridAround(const Eigen::MatrixXd& points, double size);

/**
 * The levels of a solid in the cells of a grid: at the centre of each the signed distance to the
 * solid's boundary, negative inside, where it is nearer than LevelBand cells; LevelBand cells
 * elsewhere. The solid is what `surface` winds around at least once.
 *
 * surface: closed, oriented consistently, facing outwards, inside the grid; it may cross itself.
 * boundary: what of it bounds the solid (ExtractSolidBoundary). Throws Aborted.
 */
void SampleDistances(const Mesh& surface, const SurfaceLocator& boundary, SampledGrid& grid,
  const Progress& progress = {});

/// The levels in the cells around the surface. Throws as both.
SampledGrid SampleSolidDistances(
  const Mesh& surface, const SurfaceLocator& boundary, double size, const Progress& progress = {});

} // namespace shape
