#pragma once

#include "Base/Progress.h"
#include "IO/CADModel.h"

#include <string_view>

namespace shape
{

/**
 * Reads the content of a STEP, IGES or BREP file by OpenCASCADE, and triangulates its faces. The
 * content tells the format.
 *
 * Coordinates stay in the unit of the file, or, if it has several, in the first one. Faces of a
 * region that have a common edge have its points in common, so that a closed solid has a closed
 * surface. The points on edges lie on the exact curves. Closed regions face outwards. Faces that
 * belong to no solid, as in many IGES files, are first joined along their edges. A face between two
 * solids is in both regions, with the same patch.
 *
 * Throws InvalidInput if an option is out of range, the content is of no such format or is damaged,
 * or there are no faces. Throws SolveFailure if faces cannot be triangulated or OpenCASCADE
 * crashes, and Aborted.
 */
CADModel ReadCAD(
  std::string_view content, const CADReaderOptions& options = {}, const Progress& progress = {});

} // namespace shape
