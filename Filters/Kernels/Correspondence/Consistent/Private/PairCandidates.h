#pragma once

#include "Base/Progress.h"
#include "Correspondence/Consistent/ConsistentMapsOptions.h"
#include "Correspondence/Consistent/Private/CandidateChoice.h"
#include "Correspondence/Landmarks/LandmarkCandidates.h"
#include "Correspondence/Pair/SurfaceMaps.h"

#include <array>
#include <vector>

namespace shape
{

/// Returns the points of two shapes that have the same number. One whose point has an earlier
/// number is left out.
Landmarks FindCommonLandmarks(const NumberedPoints& a, const NumberedPoints& b);

/**
 * Finds the candidate maps of pairs of shapes, of which each process finds some: those of
 * FindLandmarkCandidates, or the functional map from the landmarks (ComputeFunctionalMap) if there
 * are three or more.
 *
 * graph: the pairs. numbered: of each shape. Throws InvalidInput, SolveFailure, Aborted.
 */
std::vector<CandidatePair> MatchPairs(const std::vector<MatchedSurface>& shapes,
  const std::vector<std::array<int, 2>>& graph, const std::vector<NumberedPoints>& numbered,
  const ConsistentMapsOptions& options, const PairSharing& sharing, const Progress& progress = {});

} // namespace shape
