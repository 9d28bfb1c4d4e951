#pragma once

#include "vtkSmartPointer.h"

class vtkDataObject;
class vtkSMSourceProxy;

/// Data of the server, for what the client draws.
namespace pqShapeFetch
{

/// Makes a filter that is in no panel, undo stack or state file.
vtkSmartPointer<vtkSMSourceProxy> NewFilter(const char* name, vtkSMSourceProxy* input, int port);

/// Returns an output at the given time, with the pieces of all processes of the server: a
/// vtkPolyData, or composite data. The source must be up to date. Returns null if there are no
/// data.
vtkSmartPointer<vtkDataObject> Fetch(vtkSMSourceProxy* source, int port, double time);

} // namespace pqShapeFetch
