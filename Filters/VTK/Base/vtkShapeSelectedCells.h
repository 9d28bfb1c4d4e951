#pragma once

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkMultiProcessController;

/// The cells of a selection.
namespace vtkShapeSelectedCells
{

/// The cell array that marks them, 1 or 0.
inline const std::string Name = "vtkShapeSelected";

/**
 * Returns a copy of this process's part of `surface`, with the same tree of blocks, and adds the
 * array Name.
 *
 * selection: a vtkSelection of cells; or one of points, which selects the cells whose points are
 * all selected; or extracted cells with the array vtkOriginalCellIds, block by block. Throws
 * shape::InvalidInput if it is something else. No process waits for another.
 */
vtkSmartPointer<vtkDataObject> Mark(
  vtkDataObject* surface, vtkDataObject* selection, vtkMultiProcessController* controller);

} // namespace vtkShapeSelectedCells
