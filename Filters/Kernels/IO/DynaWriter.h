#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <ostream>

namespace shape
{

/**
 * Writes a mesh as a keyword file of LS-DYNA (LS-DYNA Keyword User's Manual, volume I), in fixed
 * columns. A model includes it: *INCLUDE.
 *
 * - *NODE has the number point + 1, and coordinates rounded to what fits in 16 columns: at least 9
 *   digits.
 * - *ELEMENT_SOLID, *ELEMENT_SHELL and *ELEMENT_BEAM have the number cell + 1 and the part
 *   region + 1. Tetrahedra, pyramids and wedges are hexahedra with repeated nodes.
 * - *PART has the name of each region: Region0, ....
 * - If the mesh has materials, the solid cells of each region and material are a part
 *   Region0_Material0, ..., and the parts are numbered in this order. They have the *SECTION_SOLID
 *   1, with one integration point, and the *MAT_ELASTIC of the number material + 1, with 3 to 8
 *   digits. Otherwise, the model has the sections and materials.
 * - If the mesh has solid cells but no surface cells, each patch of the boundary is a
 *   *SET_NODE_LIST and a *SET_SEGMENT of the number patch + 1 with the title Patch0, .... The
 *   segments face outwards. The faces between regions follow: Interface0_1, ....
 * - The points of vertex cells become the *SET_NODE_LIST Points, which has the last number.
 *
 * Throws InvalidInput if a number has more than 8 digits, which is the width of a column, and
 * Aborted. The caller checks `file` for write errors.
 */
void WriteDyna(std::ostream& file, const MeshSets& sets, const Progress& progress = {});

} // namespace shape
