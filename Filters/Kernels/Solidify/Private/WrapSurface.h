#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Solidify/MendedSurface.h"
#include "Solidify/SurfaceDefects.h"

namespace shape
{

struct WrapSurfaceOptions
{
  SurfaceDefectOptions Defects; ///< Tolerance joins points; pieces below SmallestPiece are removed
  /// The spacing of the grid, in the model's units, >= 0. 0 means 1/128 of the longest edge of the
  /// bounding box, but at most a quarter of GapSize.
  double DetailSize = 0.0;
  /// Gaps up to this width are closed, in the model's units; 0, or at least 2 DetailSize. 0 means 6
  /// DetailSize.
  double GapSize = 0.0;
  /// The thickness of the plates that sheets become (ThickenSheets), in the model's units, >= 0. 0
  /// means a tenth of DetailSize.
  double SheetThickness = 0.0;
};

/**
 * Wraps triangles in the boundary of a solid, whatever their orientation. Outside is what a ball of
 * the diameter GapSize can sweep when it comes from afar and does not touch a triangle. Cavities
 * that it cannot enter are filled.
 *
 * 1. A flood from outside through a grid passes points that are farther from the triangles than
 * half of GapSize. The air is what is closer than this to the flood, and a layer up to the
 * triangles.
 * 2. Where there is air on both sides of a triangle, it is a sheet. If this holds everywhere, the
 *    sheets become plates without a grid (ThickenSheets), and the wrap ends here.
 * 3. Otherwise, or if such plates bound no solid, points of the grid within 0.9 DetailSize from a
 *    sheet belong to the solid, which makes it a plate of the thickness 1.8 DetailSize.
 * 4. The boundary of the solid is extracted (cubical marching squares). It lies on the triangles,
 * with their creases; in gaps, on the surface that the ball cannot pass; and around sheets.
 *
 * The result is closed, a manifold, oriented outwards, and does not intersect itself; all of this
 * is checked exactly. Every triangle is made.
 *
 * surface: any triangles. Throws InvalidInput if GapSize is smaller than twice DetailSize or a
 * grid would be too large, or under the conditions of FindSurfaceDefects; Aborted.
 */
MendedSurface WrapSurface(
  const Mesh& surface, const WrapSurfaceOptions& options = {}, const Progress& progress = {});

} // namespace shape
