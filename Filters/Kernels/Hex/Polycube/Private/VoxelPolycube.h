#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Hexahedra inside a surface, each from a cell of a grid, and the positions of their points in
/// this grid.
struct VoxelPolycube
{
  HexMesh Solid;
  Eigen::MatrixXd Positions; ///< n x 3: integers, in units of cells
  double CellSize = 0.0;
};

/**
 * Builds a polycube of the solid inside a surface from the cells of a grid (Yu, Zhang, Wan and Li,
 * "Optimizing polycube domain construction for hexahedral remeshing", 2014). The solid is deformed
 * towards the axes (AlignWithAxes, FlattenAlongAxes). The cells inside the deformed solid form the
 * polycube, and they are mapped back into the solid. The polycube has the surface's topology. It
 * has a step wherever the deformed surface is not quite flat.
 *
 * surface: closed, facing outwards. compactness: see FindAxisLabels. cells: the approximate number
 * of cells. More cells are tried, up to `maximum`, until they have the surface's topology.
 *
 * Throws whatever Tetrahedralize throws. Throws SolveFailure if no tried grid has the surface's
 * topology, or if the deformation inverts more than 2 % of the volume; Aborted.
 */
VoxelPolycube FindVoxelPolycube(const Surface& surface, double compactness, int cells, int maximum,
  const Progress& progress = {});

} // namespace shape
