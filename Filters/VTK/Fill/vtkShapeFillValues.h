#pragma once

#include "Fill/FillHoles.h"
#include "Mesh/Mesh.h"

#include "vtkType.h"

#include <vector>

class vtkPolyData;

/// Data on fills.
namespace vtkShapeFillValues
{

/**
 * Replaces the data on fills. Before this call, they are copies from the nearest point of the loop.
 * Values (vtkShapeCarry::AreValues) continue smoothly from the loop (shape::ExtendValuesOntoFill).
 * Normals of points and cells are computed from the fill. surface: the surface with the fills. The
 * triangles of the fills are the cells of `output` from `firstCell` on.
 */
void Continue(const shape::Mesh& surface, const std::vector<shape::FilledHole>& holes,
  vtkIdType firstCell, vtkPolyData* output);

} // namespace vtkShapeFillValues
