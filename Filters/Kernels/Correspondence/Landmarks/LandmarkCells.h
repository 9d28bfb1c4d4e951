#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/// Maps every point to the partner of the nearest landmark along its surface, in both directions: a
/// start for methods that refine maps. Points of a component without landmarks go to the first
/// landmark's partner. Throws InvalidInput if there is no landmark, SolveFailure, Aborted.
SurfaceMaps MapByLandmarkCells(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress = {});

} // namespace shape
