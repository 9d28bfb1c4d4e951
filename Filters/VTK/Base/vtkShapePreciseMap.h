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

/// The names of the point arrays.
inline const std::string Position = "TargetPosition", Cell = "TargetCell",
                         Barycentric = "TargetBarycentric";

/// Returns whether the points have TargetCell and TargetBarycentric, and `mapArray` is
/// TargetPosition.
bool Has(vtkDataSet* data, const std::string& mapArray);

///@{
/// Returns the triangles of a surface with the numbers to which TargetCell refers. Vertices and
/// lines are numbered first, then the triangles of polygons, then the triangles of strips. Throws
/// shape::MapOfAnotherSurface if the grid has a cell of another type, and shape::InvalidInput if a
/// polygon cannot be triangulated.
shape::NumberedSurface ToSurface(vtkPolyData* surface, const std::string& name);
shape::NumberedSurface ToSurface(vtkUnstructuredGrid* grid, const std::string& name);
///@}

/// Returns the map that the arrays store, as surface points of `target` (shape::RequirePreciseMap).
/// targetName: denotes the target in errors. Throws the exceptions of shape::RequirePreciseMap, and
/// shape::InvalidInput if an array has another number of components.
shape::SurfacePoints Read(vtkDataSet* data, const std::string& name,
  const shape::NumberedSurface& target, const std::string& targetName, double tolerance = 0.01);

} // namespace vtkShapePreciseMap
