#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/// Maps every point to the partner of the landmark that is nearest along the surface, in both
/// directions. The maps are initial maps for methods that refine them. Points of a component
/// without landmarks go to the first landmark's partner. Throws InvalidInput if there is no
/// landmark; SolveFailure; Aborted.
SurfaceMaps MapByLandmarkCells(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress = {});

} // namespace shape
