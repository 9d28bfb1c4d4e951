#pragma once

#include "Fill/FillHoles.h"
#include "Mesh/Mesh.h"

#include <vector>

class vtkDataArray;
class vtkDataSetAttributes;

/// Point data on fills.
namespace vtkShapeFillValues
{

/// Extends the values of a surface from the boundary loops onto the fills
/// (shape::ExtendValuesOntoFill). points: the arrays, which already have tuples for the points of
/// the fills. Only arrays of values (vtkShapeConvert::AreValues) are changed. Values of colours are
/// rounded to bytes. leftOut: an array that is not changed, or nullptr.
void Continue(const shape::Mesh& surface, const std::vector<shape::FilledHole>& holes,
  vtkDataSetAttributes* points, const vtkDataArray* leftOut = nullptr);

} // namespace vtkShapeFillValues
