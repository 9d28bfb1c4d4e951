#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <string_view>

namespace shape
{

/// A mesh in the text format of Medit.
struct MeditMesh
{
  Cells Mesh;                      ///< kinds: constants of cell_kind, in the order of the file
  Eigen::VectorXi PointReferences; ///< n values
  Eigen::VectorXi CellReferences;  ///< m values; 0 for vertex cells, which have none in the file
};

/**
 * Reads the content of a .mesh file (Frey, "MEDIT: an interactive mesh visualization software",
 * 2001, appendix), of any version.
 *
 * Read are Vertices, Corners (as vertex cells), Edges, Triangles, Quadrilaterals, Tetrahedra,
 * Pyramids, Prisms and Hexahedra. In dimension 2, the third coordinate is 0. Other sections, such
 * as Normals or RequiredVertices, are skipped.
 *
 * Throws InvalidInput, with the line, if the file does not begin with MeshVersionFormatted, ends
 * early, has no vertices or cells of higher order, or if a number, count or index is wrong. Throws
 * Aborted.
 */
MeditMesh ReadMedit(std::string_view content, const Progress& progress = {});

} // namespace shape
