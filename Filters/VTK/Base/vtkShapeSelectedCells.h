#pragma once

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkMultiProcessController;

/// The cells that a selection names.
namespace vtkShapeSelectedCells
{

/// The cell array that marks them, 1 or 0.
inline const std::string Name = "vtkShapeSelected";

/**
 * Surfaces with the array Name, in the same tree of blocks: this process's part of what was
 * selected from.
 *
 * selection: a vtkSelection, of cells, or of points: then cells whose points are all selected; or
 * cells that were extracted, with the array vtkOriginalCellIds, block by block. Throws
 * shape::InvalidInput if it is something else. No process waits for another.
 */
vtkSmartPointer<vtkDataObject> Mark(
  vtkDataObject* surface, vtkDataObject* selection, vtkMultiProcessController* controller);

} // namespace vtkShapeSelectedCells
