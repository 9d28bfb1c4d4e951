#pragma once

#include "Base/Progress.h"
#include "IO/BoundaryPatches.h"
#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Named parts of a solver's input: a mesh, its regions, and its boundary in patches.
struct MeshSets
{
  Cells Mesh;              ///< wedges are numbered so that most are positively oriented
  Eigen::VectorXi Regions; ///< m, >= 0: the region of each cell
  int Dimension = 0;       ///< highest dimension of the cells
  SolidFaces Boundary;     ///< boundary of the solid cells
  Eigen::VectorXi Patches; ///< patch of each face of Boundary
  int PatchCount = 0;
  std::vector<RegionInterface> Interfaces; ///< between solid cells of two regions
};

/**
 * Finds the sets of a mesh.
 *
 * cells: of cell_kind, with finite points. Wedges may be numbered in either orientation, as in
 * VTK's own sources; the orientation that makes most of them positive is used. regions: m, or empty
 * for region 0. featureAngle: see FindBoundaryPatches.
 *
 * Throws InvalidInput if there is no cell, a cell has another kind, a corner is not a point of the
 * mesh, a coordinate is not finite, or a region is negative; Aborted.
 */
MeshSets FindMeshSets(const Cells& cells, const Eigen::VectorXi& regions, double featureAngle,
  const Progress& progress = {});

/// Returns the dimension of a cell_kind, from 0 for points to 3 for solids.
int GetDimension(int kind);

/// Returns the faces of each patch, as indices into Boundary.
std::vector<std::vector<int>> GroupFacesByPatch(const MeshSets& sets);

/// Returns the points of the chosen `faces` (f x 4; -1 is no point), ascending.
std::vector<int> PointsOf(const Eigen::MatrixXi& faces, const std::vector<int>& chosen);

} // namespace shape
