#pragma once

#include "Transfer/PreciseArrays.h"

#include <string>

class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/**
 * The precise maps that Shape Correspondence writes, read again: TargetCell and TargetBarycentric,
 * beside TargetPosition. `name` is what an error calls the data.
 */
namespace vtkShapePreciseMap
{

/// The arrays' names.
inline const std::string Position = "TargetPosition", Cell = "TargetCell",
                         Barycentric = "TargetBarycentric";

/// Whether the points have both arrays, and the map array is the position that they refine.
bool Has(vtkDataSet* data, const std::string& mapArray);

///@{
/// The surface's triangles by number: vertices and lines, then polygons and then strips, cut into
/// triangles. Throws shape::MapOfAnotherSurface if the grid has a cell that is none of these,
/// shape::InvalidInput if a polygon cannot be triangulated.
shape::NumberedSurface ToSurface(vtkPolyData* surface, const std::string& name);
shape::NumberedSurface ToSurface(vtkUnstructuredGrid* grid, const std::string& name);
///@}

/// The map that the arrays hold into a target, which is called targetName: see
/// shape::RequirePreciseMap. Throws shape::InvalidInput, also where an array has another number of
/// components.
shape::SurfacePoints Read(vtkDataSet* data, const std::string& name,
  const shape::NumberedSurface& target, const std::string& targetName, double tolerance = 0.01);

} // namespace vtkShapePreciseMap
