#pragma once

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkPolyData;

/// The surfaces in a data object: vtkPolyData, and unstructured grids of surface cells. `name`
/// denotes the input in errors.
namespace vtkShapeSurfaces
{

/// Returns the blocks as surfaces without ghost cells; their points are unchanged. Throws
/// shape::InvalidInput if a block is no surface.
std::vector<vtkSmartPointer<vtkPolyData>> Of(vtkDataObject* data, const std::string& name);

/**
 * Returns a vtkPolyData itself, and an unstructured grid of vertices, lines, triangles, quads,
 * polygons, pixels and strips as vtkPolyData with the same points and arrays. Its cells are ordered
 * as vtkPolyData requires: vertices, lines, polygons, strips. Throws shape::InvalidInput with the
 * number and first of all other cells.
 */
vtkSmartPointer<vtkPolyData> ToSurface(vtkDataSet* data, const std::string& name);

} // namespace vtkShapeSurfaces
