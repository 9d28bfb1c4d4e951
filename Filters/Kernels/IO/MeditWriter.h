#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <ostream>

namespace shape
{

/**
 * Writes a mesh in the text format of Medit (Frey, "MEDIT: an interactive mesh visualization
 * software", 2001, appendix), version 2, which Gmsh and Mmg also read.
 *
 * - Vertices have exact coordinates and reference 0.
 * - The reference of Hexahedra, Tetrahedra, Prisms, Pyramids, Quadrilaterals, Triangles and Edges
 *   is the region + 1. Gmsh 4.8 does not read Prisms and Pyramids. Vertex cells become Corners.
 * - If the mesh has solid cells but no surface cells, its boundary faces are written, too. They are
 *   oriented outwards, and their reference is the patch + 1. The faces between regions follow,
 *   oriented out of the region with the lower number. Their references continue those of the
 *   patches, with one reference for each pair of regions.
 *
 * Throws Aborted. The caller checks `file` for write errors.
 */
void WriteMedit(std::ostream& file, const MeshSets& sets, const Progress& progress = {});

} // namespace shape
