#pragma once

#include <string>

class vtkDataObject;
class vtkPolyData;

/// Checks of the data of an input, whichever filter reads them. `name` is the name of the input.
namespace vtkShapeComplete
{

/// Throws shape::InvalidInput if a point or cell array of a data set does not have one tuple for
/// each point or cell. Such data are invalid in VTK, and filters would read beyond the end of the
/// array.
void RequireArrays(vtkDataObject* data, const std::string& name);

/// Returns a warning if polygons have a side of (almost) no length, and otherwise an empty text.
/// They give triangles without area. ParaView's Clip makes such polygons where it cuts through
/// points.
std::string DescribeShortSides(vtkPolyData* surface, const std::string& name);

} // namespace vtkShapeComplete
