#pragma once

#include "Base/Progress.h"
#include "IO/MeshSets.h"

#include <ostream>

namespace shape
{

/// Abaqus's elements of eight nodes.
enum class HexahedronType
{
  C3D8,  ///< full integration: too stiff in bending
  C3D8R, ///< one integration point
  C3D8I  ///< with incompatible modes, for bending
};

struct AbaqusWriterOptions
{
  shape::HexahedronType HexahedronType = shape::HexahedronType::C3D8I;
};

/**
 * Writes a mesh as an input file of Abaqus, which CalculiX reads, too: to be included into a deck
 * (*INCLUDE, INPUT=mesh.inp) that has materials, sections and steps.
 *
 * - Nodes are points + 1 and elements are cells + 1; their nodes are in Abaqus's order. Elements:
 *   C3D8, C3D8R or C3D8I, C3D4, C3D6, C3D5 (pyramids, which CalculiX has not), S4, S3, T3D2, in the
 *   sets Hexahedra, Tetrahedra, Wedges, Pyramids, Quadrilaterals, Triangles, Lines. Vertices are
 *   the node set Points.
 * - Element sets Region0, ... of the regions that there are: of solid cells, or where there are
 *   none of the cells of the highest dimension.
 * - Node sets Boundary of the solid cells' boundary and Patch0, ... of its patches, and surfaces
 *   PatchSurface0, ... of their element faces S1 to S6; node sets Interface0_1, ... between solid
 *   cells of two regions.
 *
 * Coordinates are exact where that fits the 20 columns that Abaqus and CalculiX read of a number,
 * which it always does from 0.01 to 1e17 in size; else their relative error is less than 1e-12.
 *
 * Throws Aborted. What became of `file` is for its owner to look at.
 */
void WriteAbaqus(std::ostream& file, const MeshSets& sets, const AbaqusWriterOptions& options = {},
  const Progress& progress = {});

} // namespace shape
