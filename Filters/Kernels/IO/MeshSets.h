#pragma once

#include "Base/Progress.h"
#include "IO/BoundaryPatches.h"
#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// What the file of a solver names: a mesh, its regions, and its boundary in patches.
struct MeshSets
{
  Cells Mesh;              ///< wedges are numbered so that most of them are positive
  Eigen::VectorXi Regions; ///< m, 0 or greater
  int Dimension = 0;       ///< of the cells of the highest one
  SolidFaces Boundary;     ///< of its solid cells
  Eigen::VectorXi Patches; ///< of Boundary
  int PatchCount = 0;
  std::vector<RegionInterface> Interfaces; ///< between solid cells of two regions
};

/**
 * Finds the sets of a mesh.
 *
 * cells: of cell_kind, with finite points. Wedges may be numbered either way round, as VTK's own
 * sources do: what makes most of them positive is taken. regions: m, or empty for region 0.
 * featureAngle: that of FindBoundaryPatches.
 *
 * Throws InvalidInput where there is no cell or one of another kind, a corner is not there, a
 * coordinate is not finite or a region is negative; Aborted.
 */
MeshSets FindMeshSets(const Cells& cells, const Eigen::VectorXi& regions, double featureAngle,
  const Progress& progress = {});

/// 0 for points to 3 for solids; cell_kind.
int GetDimension(int kind);

/// The faces of each patch, by their index in Boundary.
std::vector<std::vector<int>> GroupFacesByPatch(const MeshSets& sets);

/// The points of the chosen ones of `faces` (f x 4; -1 is none), in rising order.
std::vector<int> PointsOf(const Eigen::MatrixXi& faces, const std::vector<int>& chosen);

} // namespace shape
