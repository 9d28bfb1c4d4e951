#pragma once

#include "Fill/FillHoles.h"
#include "Transfer/PreciseArrays.h"

#include <vector>

class vtkPolyData;

/// Conversion of a surface with filled holes to data: see vtkShapeFillHoles.
namespace vtkShapeFilledData
{

/// Writes `input` with the fills after its polygons, and the cell array `Filled`. numbered: the
/// input's triangles, which come first in `filled`.
void Write(const shape::FilledSurface& filled, const shape::NumberedSurface& numbered,
  vtkPolyData* input, vtkPolyData* output);

/// Adds the field data of each fill. loops: the number of each filled loop among all loops.
void AddFacts(
  const shape::FilledSurface& filled, const std::vector<int>& loops, vtkPolyData* output);

} // namespace vtkShapeFilledData
