#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <ostream>

namespace shape
{

/**
 * Writes a mesh in Gmsh's text format, version 4.1 (Geuzaine and Remacle, "Gmsh: a 3-D finite
 * element mesh generator", 2009; Gmsh reference manual, section "MSH file format").
 *
 * - Nodes have exact coordinates and the number point + 1. Elements have the number cell + 1.
 * - Regions are physical groups of their cells: Region0, ..., with the number region + 1.
 * - If the mesh has materials, the solid cells of each region and material are a group
 *   Region0_Material0, ..., and the groups are numbered in this order.
 * - If the mesh has solid cells but no surface cells, its boundary faces are also written, and
 *   face outwards. Patches are physical groups of surfaces: Patch0, ..., with the number patch + 1.
 *   The faces between regions follow, facing out of the region with the lower number, in physical
 *   groups Interface0_1, ..., whose numbers continue those of the patches.
 *
 * Throws Aborted. The caller checks `file` for write errors.
 */
void WriteGmsh(std::ostream& file, const MeshSets& sets, const Progress& progress = {});

} // namespace shape
