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
 * Replaces the data that the points of fills took from the nearest point of their loop. Values
 * (vtkShapeCarry::AreValues) continue smoothly from the loop (shape::ExtendValuesOntoFill); normals
 * of points and cells are those of the fill. surface: with the fills, whose triangles are the cells
 * of `output` from `firstCell` on.
 */
void Continue(const shape::Mesh& surface, const std::vector<shape::FilledHole>& holes,
  vtkIdType firstCell, vtkPolyData* output);

} // namespace vtkShapeFillValues
