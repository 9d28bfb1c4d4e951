#pragma once

#include "Base/Progress.h"
#include "IO/PolyMesh.h"

#include <ostream>
#include <vector>

namespace shape
{

/// A file of a mesh.
struct FoamFile
{
  const char* Name;
  /// Writes the content. Throws Aborted. The caller checks `file` for write errors.
  void (*Write)(std::ostream& file, const PolyMesh& mesh, const Progress& progress);
};

/**
 * Returns the files of the folder constant/polyMesh of an OpenFOAM case, in text format (OpenFOAM
 * User Guide, "Mesh description"):
 *
 * - points with exact coordinates; faces, owner and neighbour;
 * - boundary with the patches Patch0, ..., of the type patch;
 * - cellZones with the regions Region0, ...;
 * - faceZones with the faces between two regions, Interface0_1, ..., whose normals leave the region
 *   with the lower number. Without such faces the list is empty, so that no older zones remain.
 */
const std::vector<FoamFile>& GetFoamFiles();

} // namespace shape
