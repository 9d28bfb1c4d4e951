#pragma once

#include "Core/HexMesh.h"
#include "Core/Mesh.h"
#include "Core/Progress.h"

namespace shape
{

struct GridHexesOptions
{
  /// Of the grid, in the surface's units; a smaller one is used where this one cannot have the
  /// surface's topology. 0: what gives about 16,000 hexahedra.
  double CellSize = 0.0;
  int MaximumHexahedra = 200000; ///< no smaller cells are tried than give so many
};

struct GridHexesResult
{
  HexMesh Solid;
  double CellSize = 0.0;            ///< the one that was used
  double LeastScaledJacobian = 0.0; ///< positive where no hexahedron is inverted
  double MeanScaledJacobian = 0.0;
  int Inverted = 0; ///< hexahedra with a scaled Jacobian of 0 or less
};

/**
 * Hexahedra inside a closed surface: the cells of a regular grid whose centres lie in it, with a
 * layer of hexahedra around them whose outer points lie on the surface, and all points where the
 * worst scaled Jacobian is as good as it can be (OptimizeHexahedra).
 *
 * The boundary of the result is a manifold of the surface's Euler number. Cells become smaller
 * until that is so: thin parts and narrow gaps ask for it.
 *
 * surface: closed, facing outwards, one solid that hangs together. Throws InvalidInput as
 * RequireClosedSurface, and where options are out of range; SolveFailure where no grid of so few
 * cells has the topology of the surface, Aborted.
 */
GridHexesResult GridHexes(
  const Mesh& surface, const GridHexesOptions& options = {}, const Progress& progress = {});

} // namespace shape
