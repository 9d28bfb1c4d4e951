#pragma once

#include "Base/Progress.h"
#include "Hex/Grid/GridHexes.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

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
  const std::vector<Mesh>& innerSurfaces = {});

} // namespace shape
