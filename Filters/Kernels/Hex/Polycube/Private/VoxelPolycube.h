#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Hexahedra inside a surface, and where their points are as corners of cells of a grid.
struct VoxelPolycube
{
  HexMesh Solid;
  Eigen::MatrixXd Positions; ///< n x 3: whole numbers
  double CellSize = 0.0;
};

/**
 * The cells of a grid inside a solid that was bent towards the axes (AlignWithAxes,
 * FlattenAlongAxes), brought back: their union is a polycube by construction, of the surface's
 * topology, but with a step wherever the bent solid is not quite flat (Yu, Zhang, Wan and Li,
 * "Optimizing polycube domain construction for hexahedral remeshing", 2014).
 *
 * surface: closed, facing outwards. compactness: see FindAxisLabels. cells: about how many; more
 * are tried, up to `most`, until the topology agrees. Throws as Tetrahedralize; SolveFailure where
 * no such grid has the topology, Aborted.
 */
VoxelPolycube FindVoxelPolycube(const Surface& surface, double compactness, int cells, int maximum,
  const Progress& progress = {});

} // namespace shape
