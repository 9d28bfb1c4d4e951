#pragma once

#include "Mesh/Mesh.h"

#include <string>

class vtkDataObject;

/// Colours by which the eye sees a map: corresponding points of two shapes have the same colour.
namespace vtkShapeMapColors
{

/// Adds the point array `MapColors` (red, green and blue, unsigned char) to a data set or to each
/// block. The colour of a point is its position in a box.
/// positions: the name of a point array with 3 components, or empty for the points themselves.
/// mesh: the points that its triangles use span the box.
void Add(vtkDataObject* output, const std::string& positions, const shape::Mesh& mesh);

} // namespace vtkShapeMapColors
