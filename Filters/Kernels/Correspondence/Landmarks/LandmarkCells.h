#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/// The map that takes every point to the partner of the landmark nearest to it along its surface,
/// both ways: a start for methods that refine maps. At least one landmark; if a component has
/// none, its points go to the first landmark's partner. Throws InvalidInput without landmarks,
/// SolveFailure, Aborted.
SurfaceMaps MapByLandmarkCells(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress = {});

} // namespace shape
