#pragma once

#include "Harmonic/Private/FundamentalSolutionFit.h"

namespace shape
{

struct AcceleratedSetup;

/**
 * One map from charges close to the boundary (NearSurfaceChargeSystem), and more of them if that
 * leaves too much over: the triangles that hold most of it are halved, and what is left is fitted
 * with the charges of the refined boundary. Adds its levels to `result`, and keeps in `setup` what
 * the next targets on the same boundary can use.
 */
void SolveAccelerated(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  AcceleratedSetup& setup, HarmonicVolumeMapResult& result, const Progress& progress);

} // namespace shape
