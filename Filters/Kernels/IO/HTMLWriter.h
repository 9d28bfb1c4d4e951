#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace shape
{

/// Values of the points or cells of a mesh.
struct PageArray
{
  std::string Name;
  bool IsOfCells = false;
  int Components = 1;
  std::vector<float> Values; ///< Components values for each point or cell
};

/// A mesh with what a page says about it.
struct MeshPage
{
  std::string Title;
  std::vector<std::pair<std::string, std::string>> Facts; ///< names and values
  Cells Mesh; ///< kinds: constants of cell_kind, or 7 (polygon)
  std::vector<PageArray> Arrays;
};

/**
 * Writes a web page that shows the mesh. It needs no other file and no network, only a browser with
 * WebGL 2. The page colours the mesh by an array, cuts it by a plane, and hides cells by the value
 * of a cell array. Cells are shown whole. Vertices and lines are left out.
 *
 * Coordinates and values have single precision. Each number array is in four groups of bytes (the
 * first bytes of all numbers come first), which are deflated and written in base64. Indices of
 * corners are differences of neighbours.
 *
 * Throws InvalidInput if there is no surface or solid cell, or a cell of another kind. Throws
 * Aborted. The caller checks `file` for write errors.
 */
void WriteHTML(std::ostream& file, const MeshPage& page, const Progress& progress = {});

} // namespace shape
