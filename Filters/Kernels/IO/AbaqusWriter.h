#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <ostream>

namespace shape
{

/// Abaqus elements with eight nodes.
enum class HexahedronType
{
  C3D8,  ///< full integration, which is too stiff in bending
  C3D8R, ///< reduced integration with one point
  C3D8I  ///< incompatible modes, which improve bending
};

struct AbaqusWriterOptions
{
  shape::HexahedronType HexahedronType = shape::HexahedronType::C3D8I;
};

/**
 * Writes a mesh as an input file for Abaqus or CalculiX. Include the file (*INCLUDE,
 * INPUT=mesh.inp) in an input deck with steps and, if the mesh has none, materials and sections.
 *
 * - Node and element numbers are point and cell indices + 1. The nodes of an element are in the
 *   order of Abaqus. The types are C3D8, C3D8R or C3D8I for hexahedra, C3D4 for tetrahedra, C3D6
 *   for wedges, C3D5 for pyramids (which CalculiX does not support), S4 for quadrilaterals, S3 for
 *   triangles and T3D2 for lines. Each type has an element set: Hexahedra, Tetrahedra, Wedges,
 *   Pyramids, Quadrilaterals, Triangles or Lines. Vertex cells become the node set Points.
 * - The element sets Region0, ... contain the solid cells of each region. If there are no solid
 *   cells, they contain the cells of the highest dimension.
 * - If the mesh has materials, each is an element set, a linear elastic material and a solid
 *   section: Material0, .... A density of 0 is not written.
 * - The node set Boundary contains the boundary of the solid cells, and the node sets Patch0, ...
 *   contain its patches that have faces. The surfaces PatchSurface0, ... contain the element faces
 * (S1 to S6) of each patch. The node sets Interface0_1, ... contain the points shared by solid
 * cells of two regions.
 *
 * Abaqus and CalculiX read at most 20 columns of a number. Coordinates that fit in 20 columns are
 * written exactly. Coordinates with absolute values from 0.01 to 1e17 always fit. Other coordinates
 * are written with a relative error of less than 1e-12.
 *
 * Throws Aborted. The caller checks `file` for write errors.
 */
void WriteAbaqus(std::ostream& file, const MeshSets& sets, const AbaqusWriterOptions& options = {},
  const Progress& progress = {});

} // namespace shape
