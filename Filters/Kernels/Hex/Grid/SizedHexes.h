#pragma once

#include "Base/Progress.h"
#include "Hex/Grid/GridHexes.h"
#include "Hex/Voxels/GridDensity.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A grid whose cells have given sizes along a surface.
struct SizedGrid
{
  std::vector<RefinementSeed> Seeds; ///< of the space that the grid is laid in
  double CellSize = 0.0;             ///< of a cell there
  /// Shares of the surface's area where cells are at most 1.2 times as large as wanted, and at
  /// least 1 / 1.2 times.
  double NotTooLarge = 0.0, NotTooSmall = 0.0;
};

/**
 * Magnifies space around a surface so that cells of a uniform grid there have the wanted sizes on
 * it, before they are moved.
 *
 * The size that a cell has at x is that of the grid / det(DF(x))^(1/3), with the flow F of the
 * seeds. Its logarithm depends on their strengths nearly linearly, so these and the size of
 * the grid are found by Gauss and Newton's method, with seeds as wide as the surface at first
 * and more, half as wide, where that leaves more than a tenth, down to a few cells.
 *
 * surface: its triangles are all used. sizes (n): > 0, in the surface's units; between its points
 * they are linear. Throws Aborted.
 */
SizedGrid BuildSizedGrid(
  const Surface& surface, const Eigen::VectorXd& sizes, const Progress& progress = {});

/// Throws InvalidInput unless there is a positive, finite size for each of the surface's points.
void RequireSizes(const Surface& surface, const Eigen::VectorXd& sizes);

/// The sizes of quads (q: the root of the area of each), divided by the size that is
/// wanted at the position of the surface closest to its middle.
Eigen::VectorXd ComputeSizeRatios(const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads,
  const Surface& surface, const Eigen::VectorXd& sizes);

struct SizedHexesResult
{
  GridHexesResult Hexes;
  Eigen::VectorXd Ratios; ///< of the boundary's quads: see SizeRatios
};

/**
 * Hexahedra of a grid (BuildGridHexahedra) whose sizes along the surface are given: the grid is
 * laid in a space that is magnified where they are to be small (BuildSizedGrid). What a first
 * mesh's quads are too large or too small, nearby on average, the second one's grid makes up for.
 *
 * Smaller hexahedra are used where the solid's topology or a good fit asks for them.
 *
 * surface: closed, oriented consistently. sizes: one for each of its points, > 0, in its units.
 * options: CellSize and Seeds are not used. Throws InvalidInput as RequireSizes, and as
 * BuildGridHexahedra throws.
 */
SizedHexesResult BuildSizedHexahedra(const Surface& surface, const Eigen::VectorXd& sizes,
  GridHexesOptions options = {}, const Progress& progress = {},
  const std::vector<Surface>& innerSurfaces = {});

} // namespace shape
