#pragma once

#include "Transfer/PreciseArrays.h"

#include <string>

class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/**
 * Reads the precise maps that Shape Correspondence writes: TargetCell and TargetBarycentric, in
 * addition to TargetPosition. `name` denotes the data in errors.
 */
namespace vtkShapePreciseMap
{

/// The arrays' names.
inline const std::string Position = "TargetPosition", Cell = "TargetCell",
                         Barycentric = "TargetBarycentric";

/// Returns whether the points have both arrays and the map array is TargetPosition.
bool Has(vtkDataSet* data, const std::string& mapArray);

///@{
/// Returns the surface's triangles with their numbers. Vertices and lines are numbered first, then
/// the triangles of polygons, then those of strips. Throws shape::MapOfAnotherSurface if the grid
/// has another type of cell,
/// shape::InvalidInput if a polygon cannot be triangulated.
shape::NumberedSurface ToSurface(vtkPolyData* surface, const std::string& name);
shape::NumberedSurface ToSurface(vtkUnstructuredGrid* grid, const std::string& name);
///@}

/// Returns the map into a target that the arrays store: see shape::RequirePreciseMap. targetName
/// denotes the target in errors. Throws shape::InvalidInput, also if an array has another number of
/// components.
shape::SurfacePoints Read(vtkDataSet* data, const std::string& name,
  const shape::NumberedSurface& target, const std::string& targetName, double tolerance = 0.01);

} // namespace vtkShapePreciseMap
