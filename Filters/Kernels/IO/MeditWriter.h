#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <ostream>

namespace shape
{

/**
 * Writes a mesh in the text format of Medit (Frey, "MEDIT: an interactive mesh visualization
 * software", 2001, appendix), version 2, which Gmsh and Mmg read, too.
 *
 * - Vertices with every bit of their coordinates, and the reference 0.
 * - Hexahedra, Tetrahedra, Prisms, Pyramids, Quadrilaterals, Triangles, Edges; their reference is
 *   the region + 1. Gmsh 4.8 does not know Prisms and Pyramids. Vertices alone are Corners.
 * - Where the mesh has solid cells and no surface cells of its own, the faces of its boundary,
 *   seen from outside, with the patch + 1 as reference, and those between two regions, seen from
 *   the lower one, with the references after: in the order of the pairs of regions.
 *
 * Throws Aborted. What became of `file` is for its owner to look at.
 */
void WriteMedit(std::ostream& file, const MeshSets& sets, const Progress& progress = {});

} // namespace shape
