#pragma once

#include "Fill/FillHoles.h"
#include "Mesh/Mesh.h"

#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;

/// Data of the points of fills.
namespace vtkShapeFillValues
{

/// Carries a surface's values (vtkShapeConvert::AreValues) on from the boundary loops of its fills:
/// see shape::ExtendValuesOntoFill. points: tuples for the fills, too; those of bytes, which are
/// colours, are rounded. leftOut: an array that stays as it is, or nullptr.
void Continue(const shape::Mesh& surface, const std::vector<shape::FilledHole>& holes,
  vtkDataSetAttributes* points, const vtkDataArray* leftOut = nullptr);

} // namespace vtkShapeFillValues
