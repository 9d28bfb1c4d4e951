#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Hexahedra inside a surface, and the positions of their points in the grid that they come from.
struct VoxelPolycube
{
  HexMesh Solid;
  Eigen::MatrixXd Positions; ///< n x 3: integers
  double CellSize = 0.0;
};

/**
 * Takes the cells of a grid inside a solid that was deformed towards the axes (AlignWithAxes,
 * FlattenAlongAxes) and maps them back. Their union is a polycube by construction and has the
 * surface's topology. It has a step wherever the deformed solid is not quite flat (Yu, Zhang, Wan
 * and Li, "Optimizing polycube domain construction for hexahedral remeshing", 2014).
 *
 * surface: closed, facing outwards. compactness: see FindAxisLabels. cells: their approximate
 * number; more are tried, up to `maximum`, until the topology agrees. Throws what Tetrahedralize
 * throws; SolveFailure if no such grid has the topology; Aborted.
 */
VoxelPolycube FindVoxelPolycube(const Surface& surface, double compactness, int cells, int maximum,
  const Progress& progress = {});

} // namespace shape
