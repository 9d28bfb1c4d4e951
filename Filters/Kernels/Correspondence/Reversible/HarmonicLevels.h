#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/CoarsePair.h"
#include "Correspondence/Reversible/ReversibleHarmonic.h"

namespace shape
{

/**
 * ReversibleHarmonic of the coarse surfaces of a pair, and where these have fewer points than the
 * fine ones the last quarter of the steps of alpha again, of these, from what the coarse ones find:
 * the smooth part of the maps, which takes most iterations, is then in place. The embedding's
 * samples are those of the coarse surfaces.
 *
 * start: of the coarse surfaces; landmarks: of the coarse ones. Returns the maps of the fine
 * surfaces; Energies are the coarse ones'. Throws InvalidInput, SolveFailure, Aborted.
 */
ReversibleHarmonicResult RefineReversibleHarmonicMap(const CoarsePair& pair,
  const SurfaceMaps& start, const Landmarks& landmarks,
  const ReversibleHarmonicOptions& options = {}, const Progress& progress = {});

} // namespace shape
