#pragma once

#include "Base/Progress.h"
#include "IO/CADModel.h"
#include "IO/Private/OpenCascade.h"

#include <string_view>

namespace shape
{

/// Joins the triangulated faces along their edges (JoinFaces), in a child process that also runs
/// OpenCASCADE. Throws the exceptions of ReadCAD. OpenEdges is not counted.
CADModel RunCADProcess(std::string_view content, CADFormat format, const CADReaderOptions& options,
  const Progress& progress);

} // namespace shape
