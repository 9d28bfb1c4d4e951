#pragma once

#include "Fill/FillHoles.h"
#include "Transfer/PreciseArrays.h"

#include <vector>

class vtkPolyData;

/// A surface with its holes filled, as data: see vtkShapeFillHoles.
namespace vtkShapeFilledData
{

/// Writes `input` with the fills behind its polygons, and the cell array `Filled`. numbered: the
/// input's triangles, which come first in `filled`.
void Write(const shape::FilledSurface& filled, const shape::NumberedSurface& numbered,
  vtkPolyData* input, vtkPolyData* output);

/// The field data of each fill. loops: what number each has among all.
void AddFacts(
  const shape::FilledSurface& filled, const std::vector<int>& loops, vtkPolyData* output);

} // namespace vtkShapeFilledData
