#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"
#include "Mesh/Mesh.h"
#include "Untangle/Untangle.h"

#include <string>
#include <utility>

class vtkDataObject;
class vtkMultiProcessController;
class vtkUnstructuredGrid;

/// Conversion of solid cells to kernel types and back, after their points were moved and some cells
/// were split.
namespace vtkShapeSolid
{

/// Returns the cells of a grid, with voxels as hexahedra. Throws shape::InvalidInput if a cell is
/// not a tetrahedron, pyramid, wedge or hexahedron; `name` denotes the grid in the message.
shape::Cells Read(vtkUnstructuredGrid* grid, const std::string& name);

/// Throws shape::InvalidInput if a block of `data` is not a data set.
void RequireDataSets(vtkDataObject* data);

/// Writes the untangled cells to `output`, with the data of `input` and the arrays
/// `OriginalPointId`, `OriginalCellId`, `Inverted` and `SourcePosition`. sources: n x 3, the
/// SourcePosition of each point of `input`.
void Write(const shape::UntangleResult& result, vtkUnstructuredGrid* input,
  const Eigen::MatrixXd& sources, vtkUnstructuredGrid* output);

/**
 * Untangles `moved`, the image of `domain` under the volume map that takes `boundary` to `targets`
 * (shape::ComputeFoldFreeMap). Unstructured grids get the arrays of Write, structured grids only
 * `Inverted`. Returns the numbers of inverted cells before and after. Throws shape::InvalidInput if
 * the domain has no solid cells, has several blocks, or has pieces on several processes.
 */
std::pair<int, int> MakeFoldFree(vtkDataObject* domain, vtkDataObject* moved,
  const shape::Mesh& boundary, const Eigen::MatrixXd& targets,
  vtkMultiProcessController* controller, const shape::Progress& progress);

/// Throws shape::InvalidInput if `domain` has no solid cells, has several blocks, or has pieces on
/// several processes.
void RequireOneSolid(vtkDataObject* domain, vtkMultiProcessController* controller);

} // namespace vtkShapeSolid
