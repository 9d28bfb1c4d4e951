#pragma once

#include "Fill/FillHoles.h"
#include "Mesh/Mesh.h"

#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;

/// Point data of fills.
namespace vtkShapeFillValues
{

/// Extends a surface's values (vtkShapeConvert::AreValues) from the boundary loops onto the fills:
/// see shape::ExtendValuesOntoFill. points: arrays with tuples for the points of the fills as well;
/// bytes, which are colours, are rounded. leftOut: an array that is not changed, or nullptr.
void Continue(const shape::Mesh& surface, const std::vector<shape::FilledHole>& holes,
  vtkDataSetAttributes* points, const vtkDataArray* leftOut = nullptr);

} // namespace vtkShapeFillValues
