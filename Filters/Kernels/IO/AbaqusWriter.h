#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <ostream>

namespace shape
{

/// Abaqus elements with eight nodes.
enum class HexahedronType
{
  C3D8,  ///< full integration: too stiff in bending
  C3D8R, ///< one integration point
  C3D8I  ///< incompatible modes, for bending
};

struct AbaqusWriterOptions
{
  shape::HexahedronType HexahedronType = shape::HexahedronType::C3D8I;
};

/**
 * Writes a mesh as an input file of Abaqus, which CalculiX also reads. Include it (*INCLUDE,
 * INPUT=mesh.inp) in an input deck with materials, sections and steps.
 *
 * - Node and element numbers are point and cell numbers + 1; element nodes are in Abaqus's order.
 *   The elements are C3D8, C3D8R or C3D8I, C3D4, C3D6, C3D5 (pyramids, not supported by CalculiX),
 *   S4, S3 and T3D2. Their sets are Hexahedra, Tetrahedra, Wedges, Pyramids, Quadrilaterals,
 *   Triangles and Lines. Vertices are the node set Points.
 * - Element sets Region0, ... contain the solid cells of each region or, without solid cells, the
 *   cells of the highest dimension.
 * - Node set Boundary contains the solid cells' boundary, Patch0, ... its patches; surfaces
 *   PatchSurface0, ... contain the patches' element faces S1 to S6. Node sets Interface0_1, ... lie
 *   between the solid cells of two regions.
 *
 * Coordinates are exact if they fit in 20 columns, which Abaqus and CalculiX read of a number.
 * Sizes from 0.01 to 1e17 always fit; others have a relative error of less than 1e-12.
 *
 * Throws Aborted. The caller checks `file` for write errors.
 */
void WriteAbaqus(std::ostream& file, const MeshSets& sets, const AbaqusWriterOptions& options = {},
  const Progress& progress = {});

} // namespace shape
