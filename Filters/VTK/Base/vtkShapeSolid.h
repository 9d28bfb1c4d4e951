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

/// Solid cells whose points were moved, and of which some were split, as data.
namespace vtkShapeSolid
{

/// The cells of a grid, voxels as hexahedra. Throws shape::InvalidInput if a cell is no
/// tetrahedron, pyramid, wedge or hexahedron; `name` is what the message calls the grid.
shape::Cells Read(vtkUnstructuredGrid* grid, const std::string& name);

/// Throws shape::InvalidInput if a block of `data` is no data set.
void RequireDataSets(vtkDataObject* data);

/// Makes `output` the untangled cells with the data of `input`, `OriginalPointId`,
/// `OriginalCellId` and `Inverted`. sources (n x 3): SourcePosition of the input's points.
void Write(const shape::UntangleResult& result, vtkUnstructuredGrid* input,
  const Eigen::MatrixXd& sources, vtkUnstructuredGrid* output);

/**
 * Replaces `moved`, which is what a map of its boundary's surface made of `domain`, by the cells
 * without inverted ones (shape::ComputeFoldFreeMap). Returns how many were inverted before and are
 * so still. Throws shape::InvalidInput if the domain has no solid cells, or is in several blocks
 * or on several processes.
 */
std::pair<int, int> MakeFoldFree(vtkDataObject* domain, vtkDataObject* moved,
  const shape::Mesh& boundary, const Eigen::MatrixXd& targets,
  vtkMultiProcessController* controller, const shape::Progress& progress);

/// Throws shape::InvalidInput unless MakeFoldFree can work on `domain`.
void RequireOneSolid(vtkDataObject* domain, vtkMultiProcessController* controller);

} // namespace vtkShapeSolid
