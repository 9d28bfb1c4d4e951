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
  std::vector<RefinementSeed> Seeds; ///< magnify the space that the grid is laid in
  double CellSize = 0.0;             ///< the size of a cell in the magnified space
  /// Fractions of the positions sampled on the surface. NotTooLarge: where the cell size is at most
  /// 1.2 times the wanted size. NotTooSmall: where it is at least 1 / 1.2 times the wanted size.
  double NotTooLarge = 0.0, NotTooSmall = 0.0;
};

/**
 * Magnifies the space around a surface. The cells of a uniform grid in the magnified space, mapped
 * back, then have the wanted sizes along the surface. This holds for the cells before their points
 * are optimised.
 *
 * The cell size at x is CellSize / det(DF(x))^(1/3), where F is the flow of the seeds
 * (GridDensity). The logarithm of this size depends almost linearly on the strengths of the seeds,
 * so a Gauss-Newton method finds the strengths and CellSize. The first seeds are as wide as the
 * surface. Where the size is still wrong by more than a tenth, seeds of half the width are added,
 * down to a width of a few cells.
 *
 * surface: a surface without unused points. sizes: the wanted cell size at each point, > 0, in the
 * surface's units; interpolated linearly between the points. Throws Aborted.
 */
SizedGrid BuildSizedGrid(
  const Surface& surface, const Eigen::VectorXd& sizes, const Progress& progress = {});

/// Throws InvalidInput unless each point of the surface has a positive, finite size.
void RequireSizes(const Surface& surface, const Eigen::VectorXd& sizes);

/// Returns, for each quad (q), its size divided by the wanted size. The size of a quad is the
/// square root of its area. The wanted size is taken at the position on the surface closest to the
/// quad's centroid.
Eigen::VectorXd ComputeSizeRatios(const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads,
  const Surface& surface, const Eigen::VectorXd& sizes);

struct SizedHexesResult
{
  GridHexesResult Hexes;
  Eigen::VectorXd Ratios; ///< the size ratio of each boundary quad (ComputeSizeRatios)
};

/**
 * Builds hexahedra from a grid (BuildGridHexahedra) with prescribed sizes along the surface. The
 * grid is laid in a space that is magnified where hexahedra should be small (BuildSizedGrid). A
 * first grid shows by how much the sizes are wrong. A second grid corrects the local mean of these
 * errors.
 *
 * Smaller hexahedra are used where the solid's topology or a good fit needs them.
 *
 * surface: closed and consistently oriented. sizes: the wanted size at each point of the surface, >
 * 0, in the surface's units. options: CellSize, Seeds and Snap are ignored. Throws InvalidInput
 * under the conditions of RequireSizes, and whatever BuildGridHexahedra throws.
 */
SizedHexesResult BuildSizedHexahedra(const Surface& surface, const Eigen::VectorXd& sizes,
  GridHexesOptions options = {}, const Progress& progress = {},
  const std::vector<Surface>& innerSurfaces = {});

} // namespace shape
