#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <ostream>

namespace shape
{

/**
 * Writes a mesh as an Exodus II file (Schoof and Yarberry, "EXODUS II: a finite element data
 * model", 1994), which is a netCDF file.
 *
 * - Coordinates are exact. Nodes are numbered as the points, from 1. The element number map has
 *   cell + 1.
 * - The cells of a region are the element block Region0, ..., with the number region + 1. If a
 *   region has several kinds of cells, each kind is a block: Region0_hex8. The first has the
 *   number region + 1, and the others follow the largest region + 1.
 * - The patches of the boundary of the solid cells are side sets and node sets: Patch0, ..., with
 *   the number patch + 1. The faces between regions follow, as sides of the region with the lower
 *   number: Interface0_1, ....
 *
 * Throws InvalidInput if a block needs 4 GiB or more, and Aborted. The caller checks `file` for
 * write errors.
 */
void WriteExodus(std::ostream& file, const MeshSets& sets, const Progress& progress = {});

} // namespace shape
