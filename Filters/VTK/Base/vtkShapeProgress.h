#pragma once

#include "vtkShapeFiltersModule.h" // for the export macro

#include "Base/Progress.h"

#include <functional>
#include <string>

class vtkAlgorithm;

/// How kernels report to the filters that run them, and how filters are stopped.
namespace vtkShapeProgress
{

/// Returns a Progress that passes fractions on to an algorithm, and "label: stage" as its progress
/// text. It stops the kernel when AbortExecute of the algorithm is set, or when a stop is requested
/// (SetStopRequest).
shape::Progress Make(vtkAlgorithm* algorithm, const std::string& label);

/// Lets the program that runs the filters stop them: a filter keeps its process busy until it ends,
/// so nothing else could set its AbortExecute. `isWanted` is called at every report, in the thread
/// of the filter that reports; if it returns true, that filter stops. AbortExecute remains as it
/// is, because it would also stop the next run. An empty function removes the previous one.
VTKSHAPEFILTERS_EXPORT void SetStopRequest(std::function<bool()> isWanted);

} // namespace vtkShapeProgress
