#pragma once

#include "Base/Progress.h"
#include "Hex/Grid/GridHexes.h"
#include "Hex/Voxels/GridDensity.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A grid whose cells have prescribed sizes along a surface.
struct SizedGrid
{
  std::vector<RefinementSeed> Seeds; ///< seeds of the magnified space that the grid is laid in
  double CellSize = 0.0;             ///< the size of a cell in that space
  /// Fractions of the surface's area on which cells are at most 1.2 times as large as wanted, and
  /// at least 1 / 1.2 times as large.
  double NotTooLarge = 0.0, NotTooSmall = 0.0;
};

/**
 * Magnifies the space around a surface. The cells of a uniform grid in the magnified space have the
 * wanted sizes along the surface before the points are optimised.
 *
 * The cell size at x is the grid's size / det(DF(x))^(1/3), with the flow F of the seeds. Its
 * logarithm depends almost linearly on the strengths of the seeds, so a Gauss-Newton method finds
 * the strengths and the size of the grid. The first seeds are as wide as the surface. Seeds of half
 * the width are added where an error of more than a tenth remains, down to a width of a few cells.
 *
 * surface: uses all of its points. sizes (n): > 0, in the surface's units, interpolated linearly
 * between the points. Throws Aborted.
 */
SizedGrid BuildSizedGrid(
  const Surface& surface, const Eigen::VectorXd& sizes, const Progress& progress = {});

/// Throws InvalidInput unless each point of the surface has a positive, finite size.
void RequireSizes(const Surface& surface, const Eigen::VectorXd& sizes);

/// Returns the size of each quad (q) divided by the wanted size. The size is the square root of the
/// quad's area; the wanted size is taken at the point of the surface closest to its centroid.
Eigen::VectorXd ComputeSizeRatios(const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads,
  const Surface& surface, const Eigen::VectorXd& sizes);

struct SizedHexesResult
{
  GridHexesResult Hexes;
  Eigen::VectorXd Ratios; ///< the size ratio of each boundary quad (ComputeSizeRatios)
};

/**
 * Builds the hexahedra of a grid (BuildGridHexahedra) with prescribed sizes along the surface. The
 * grid is laid in a space that is magnified where they should be small (BuildSizedGrid). A second
 * grid corrects the local mean error of the sizes in the first mesh.
 *
 * Smaller hexahedra are used where the solid's topology or a good fit needs them.
 *
 * surface: closed and consistently oriented. sizes: one for each of its points, > 0, in its units.
 * options: CellSize and Seeds are ignored. Throws InvalidInput under the conditions of
 * RequireSizes, and whatever BuildGridHexahedra throws.
 * BuildGridHexahedra throws.
 */
SizedHexesResult BuildSizedHexahedra(const Surface& surface, const Eigen::VectorXd& sizes,
  GridHexesOptions options = {}, const Progress& progress = {},
  const std::vector<Surface>& innerSurfaces = {});

} // namespace shape
