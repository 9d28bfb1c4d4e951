#pragma once

#include <string>

class vtkDataObject;
class vtkPolyData;
class vtkShapeAlgorithm;

/// Checks of the data of an input, whichever filter reads them. `name` is the name of the input.
namespace vtkShapeComplete
{

/// Throws shape::InvalidInput on every process unless every process has the same number of
/// connections to each input, and at least one to each required input. Collective.
void RequireConnections(vtkShapeAlgorithm& filter);

/// Throws shape::InvalidInput if a point or cell array of a data set does not have one tuple for
/// each point or cell. Such data are invalid in VTK, and filters would read beyond the end of the
/// array.
void RequireArrays(vtkDataObject* data, const std::string& name);

/// Throws shape::InvalidInput if the data are points alone, without polygons, strips and lines.
/// reason: why polygons are necessary, said in the message.
void RequireNoPointCloud(vtkPolyData* data, const std::string& name, const std::string& reason);

/// Returns a warning if polygons have a side of (almost) no length, and otherwise an empty text.
/// They give triangles without area. ParaView's Clip makes such polygons where it cuts through
/// points.
std::string DescribeShortSides(vtkPolyData* surface, const std::string& name);

} // namespace vtkShapeComplete
