#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// Faces First, ..., First + Count - 1 of a PolyMesh.
struct FacePatch
{
  std::string Name;
  int First, Count;
};

struct CellZone
{
  std::string Name;
  std::vector<int> Cells; ///< ascending
};

struct FaceZone
{
  std::string Name;
  std::vector<int> Faces;
  std::vector<bool> Flips; ///< whether the zone's normal is opposite to that of the face
};

/**
 * A mesh given by its faces and by the cells on both sides of each, as in OpenFOAM (Weller et al.,
 * "A tensorial approach to computational continuum mechanics using object-oriented techniques",
 * 1998; OpenFOAM User Guide, "Mesh description").
 *
 * Each face is there once. The inner faces come first, in upper-triangular order: by owner, then by
 * neighbour. The faces of the patches follow, patch by patch.
 */
struct PolyMesh
{
  Eigen::MatrixXd Points;     ///< those of the cells, in their order; unused ones are left out
  Eigen::MatrixXi Faces;      ///< f x 4 points, counter-clockwise seen from outside of the owner;
                              ///< the last is -1 in triangles
  Eigen::VectorXi Owners;     ///< f: of an inner face, the cell with the lower number
  Eigen::VectorXi Neighbours; ///< of the inner faces: the other cell
  int CellCount = 0;
  std::vector<FacePatch> Patches;  ///< the boundary: Patch0, ...
  std::vector<CellZone> CellZones; ///< a partition of the cells: Region0, ...
  std::vector<FaceZone> FaceZones; ///< Interface0_1, ..., whose normals leave the lower region
};

/**
 * Returns the faces of a mesh of solid cells. Cells keep their numbers. A cell whose corners are
 * numbered inside out, with a negative volume, is turned: only its faces are in the result. Flat
 * cells are taken as they are numbered. Patches without faces are left out.
 *
 * Throws InvalidInput if a cell is not solid, a cell has a point twice, more than two cells have
 * the same face, or both cells of a face are on the same side of it, as a neighbour of an inverted
 * cell is. Throws Aborted.
 */
PolyMesh MakePolyMesh(const MeshSets& sets, const Progress& progress = {});

} // namespace shape
