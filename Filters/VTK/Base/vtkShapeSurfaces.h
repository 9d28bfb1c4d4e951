#pragma once

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkMultiProcessController;
class vtkPolyData;

/// The surfaces in a data object: vtkPolyData, unstructured grids of surface cells, and boundaries
/// of solids. `name` denotes the input in errors.
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

/**
 * Returns `data`, or the boundary of a solid: an unstructured grid of the faces that belong to one
 * cell alone, in the order of the cells, facing outwards. It has only the points of these faces,
 * with their arrays, and the cell arrays of the cells that the faces belong to. Collective
 * (vtkShapeGather). Throws shape::InvalidInput on every process if there are several blocks or
 * pieces, or if the solid has cells other than tetrahedra, pyramids, wedges, hexahedra and voxels.
 */
vtkSmartPointer<vtkDataObject> SolidAsBoundary(
  vtkDataObject* data, const std::string& name, vtkMultiProcessController* controller);

} // namespace vtkShapeSurfaces
