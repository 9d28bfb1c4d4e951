#pragma once

#include "Harmonic/Private/FundamentalSolutionFit.h"

namespace shape
{

struct AcceleratedSetup;

/**
 * Fits a map with charges close to the boundary (NearSurfaceChargeSystem). While the residual is
 * above the tolerance, the triangles with the largest residual are bisected and a further map is
 * fitted with the charges of the refined boundary. Each fitted map is appended to `result` as a
 * level. `setup` keeps the system of the boundary for calls with other targets.
 */
void SolveAccelerated(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  AcceleratedSetup& setup, HarmonicVolumeMapResult& result, const Progress& progress);

} // namespace shape
