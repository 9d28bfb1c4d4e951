#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <ostream>

namespace shape
{

/**
 * Writes the mesh section of a FEBio model, specification 4.0 (FEBio User's Manual, chapter
 * "Mesh section"). The model includes it: <Mesh from="mesh.feb"/>.
 *
 * - Nodes have exact coordinates and the number point + 1. Elements have the number cell + 1.
 * - The cells of a region are the part Region0, .... If a region has several kinds of cells, each
 *   kind is a part: Region0_hex8.
 * - If the mesh has materials, the solid cells of each region and material are a part
 *   Region0_Material0, .... The sections Material and MeshDomains define the materials, which are
 *   isotropic elastic, and assign them to the parts.
 * - If the mesh has solid cells but no surface cells, the patches of the boundary are surfaces and
 *   node sets: Patch0, .... They face outwards. The faces between regions follow, facing out of the
 *   region with the lower number: Interface0_1, ....
 * - The points of vertex cells become the node set Points.
 *
 * Throws Aborted. The caller checks `file` for write errors.
 */
void WriteFebio(std::ostream& file, const MeshSets& sets, const Progress& progress = {});

} // namespace shape
