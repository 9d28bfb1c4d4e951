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
 * - Hexahedra, Tetrahedra, Prisms, Pyramids, Quadrilaterals, Triangles, Edges have the region + 1
 *   as reference. Gmsh 4.8 does not read Prisms and Pyramids. Vertex cells become Corners.
 * - If the mesh has solid cells but no surface cells, boundary faces are written, oriented
 *   outwards, with the patch + 1 as reference. Faces between two regions follow, oriented out of
 *   the lower region, with the next references in the order of the pairs of regions.
 *
 * Throws Aborted. The caller checks `file` for write errors.
 */
void WriteMedit(std::ostream& file, const MeshSets& sets, const Progress& progress = {});

} // namespace shape
