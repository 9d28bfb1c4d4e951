#pragma once

#include "Core/Cells.h"
#include "Volume/Untangle.h"

#include <string>

class vtkDataObject;
class vtkUnstructuredGrid;

/// Solid cells whose points were moved, and of which some were split, as data.
namespace vtkShapeSolid
{

/// The cells of a grid, voxels as hexahedra. Throws shape::InvalidInput where a cell is no
/// tetrahedron, pyramid, wedge or hexahedron; `name` is what the message calls the grid.
shape::Cells Read(vtkUnstructuredGrid* grid, const std::string& name);

/// Throws shape::InvalidInput where a block of `data` is no data set.
void RequireDataSets(vtkDataObject* data);

/// Makes `output` the untangled cells with the data of `input`, `OriginalPointId`,
/// `OriginalCellId` and `Inverted`. sources (n x 3): SourcePosition of the input's points.
void Write(const shape::UntangleResult& result, vtkUnstructuredGrid* input,
  const Eigen::MatrixXd& sources, vtkUnstructuredGrid* output);

} // namespace vtkShapeSolid
