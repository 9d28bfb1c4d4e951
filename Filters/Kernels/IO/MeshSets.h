#pragma once

#include "Base/Progress.h"
#include "IO/BoundaryPatches.h"
#include "IO/MeshMaterials.h"
#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The parts of a mesh that a solver needs by name: its regions, its interfaces, and its boundary
/// in patches.
struct MeshSets
{
  Cells Mesh;              ///< its wedges are numbered so that most of them have positive volume
  Eigen::VectorXi Regions; ///< m values, each >= 0: the region of each cell
  MeshMaterials Materials; ///< of the solid cells; FindMeshSets finds none
  int Dimension = 0;       ///< highest dimension of the cells
  SolidFaces Boundary;     ///< boundary of the solid cells
  Eigen::VectorXi Patches; ///< patch of each face of Boundary
  int PatchCount = 0;      ///< highest patch + 1; patches without faces are possible
  std::vector<RegionInterface> Interfaces; ///< between solid cells of two regions
};

/**
 * Finds the sets of a mesh.
 *
 * cells: their kinds are constants of cell_kind, and their points are finite. The points of wedges
 * may be numbered in either orientation, because VTK's own sources use both. The orientation that
 * makes most wedges positive is used for all. regions: m values, one for each cell; empty if all
 * cells are in region 0. featureAngle: see FindBoundaryPatches. facePatches: m x 6, the patch of
 * each face (GetFaces in Mesh/CellFaces.h) of each cell, -1 for faces without one; empty if there
 * are none. Only the faces of hexahedra are looked up. Boundary faces without a patch are divided
 * by featureAngle, and their patches are numbered after the given ones.
 *
 * Throws InvalidInput if there is no cell, a cell is of another kind, a corner is not a point of
 * the mesh, a coordinate is not finite, a region is negative, or a patch is less than -1 or not
 * less than the number of faces. Throws the exceptions of FindBoundaryPatches, and Aborted.
 */
MeshSets FindMeshSets(const Cells& cells, const Eigen::VectorXi& regions, double featureAngle,
  const Eigen::MatrixXi& facePatches = {}, const Progress& progress = {});

/// Returns the dimension of a kind of cell (cell_kind): 0 for vertices, 1 for lines, 2 for surface
/// cells and 3 for solid cells.
int GetDimension(int kind);

/// Returns the faces of each patch, as indices into sets.Boundary.
std::vector<std::vector<int>> GroupFacesByPatch(const MeshSets& sets);

/// Returns the points of some faces, in ascending order. faces: f x 4 point indices, of which -1 is
/// ignored. chosen: indices of faces.
std::vector<int> PointsOf(const Eigen::MatrixXi& faces, const std::vector<int>& chosen);

} // namespace shape
