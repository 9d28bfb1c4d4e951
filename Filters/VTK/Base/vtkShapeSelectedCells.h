#pragma once

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkMultiProcessController;

/// Conversion of a selection to a cell array.
namespace vtkShapeSelectedCells
{

/// The name of the cell array: 1 in selected cells, otherwise 0.
inline const std::string Name = "vtkShapeSelected";

/**
 * Returns a copy of this process's part of `surface`, with the same blocks and the additional cell
 * array Name.
 *
 * selection: one of three things. A vtkSelection of cells; a vtkSelection of points, which selects
 * the cells whose points are all selected; or the extracted cells, in the same blocks, with the
 * array vtkOriginalCellIds. Throws shape::InvalidInput if it is none of these, on the process that
 * detects it. The function is not collective: no process waits for another.
 */
vtkSmartPointer<vtkDataObject> Mark(
  vtkDataObject* surface, vtkDataObject* selection, vtkMultiProcessController* controller);

} // namespace vtkShapeSelectedCells
