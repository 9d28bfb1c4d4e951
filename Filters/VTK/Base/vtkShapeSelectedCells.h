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
 * selection: a vtkSelection of cells or points, or extracted cells with the array
 * vtkOriginalCellIds. It has the same blocks as `surface`. Selected points stand for the cells
 * whose points are all selected. Throws shape::InvalidInput if `selection` is none of these. The
 * function is not collective: no process waits for another.
 */
vtkSmartPointer<vtkDataObject> Mark(
  vtkDataObject* surface, vtkDataObject* selection, vtkMultiProcessController* controller);

} // namespace vtkShapeSelectedCells
