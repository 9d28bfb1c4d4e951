#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Solidify/MendedSurface.h"
#include "Solidify/SurfaceDefects.h"

namespace shape
{

/**
 * Makes sheets plates: each point becomes two, on either side of its sheet along the normal, and
 * strips along the boundary join them. Plates that cross are united exactly (MakeSolid).
 *
 * thickness: of the plates, in the surface's units; it is halved up to four times until they bound
 * a solid. The sheets are drafted as in MendSurface. Every triangle of the result is made.
 *
 * Throws InvalidInput or SolveFailure if plates of no such thickness bound a solid; Aborted.
 */
MendedSurface ThickenSheets(const Mesh& surface, double thickness,
  const SurfaceDefectOptions& options, const Progress& progress = {});

} // namespace shape
