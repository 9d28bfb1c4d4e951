#pragma once

#include "Base/Progress.h"
#include "Correspondence/Consistent/Private/CandidateChoice.h"
#include "Correspondence/Landmarks/LandmarkCandidates.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <array>
#include <functional>
#include <vector>

namespace shape
{

/// Returns the triples of shapes of which all pairs have a map: 300 evenly spread ones, if there
/// are more.
std::vector<std::array<int, 3>> FindTriples(const std::vector<CandidatePair>& pairs);

/// Takes positions on one shape to another one. The arguments are their numbers and the positions.
using PositionMap = std::function<SurfacePoints(int, int, const SurfacePoints&)>;

/// The maps over the template: Maps.AToB of one shape, then the inverse of that of the other one
/// (MapInverse), which is not interpolated between points, as MapsOfPairs is not. The
/// arguments must outlive the result, except `central`, the number of the template.
PositionMap MapsOverTemplate(
  const std::vector<Surface>& surfaces, std::size_t central, const std::vector<SurfaceMaps>& maps);

/// The best functional map of each pair alone, which must have one. The arguments must outlive the
/// result.
PositionMap MapsOfPairs(const std::vector<Surface>& surfaces,
  const std::vector<MatchedSurface>& matched, const std::vector<CandidatePair>& pairs);

/// Returns the mean distance of points from their images after going around the triples, divided
/// by the root of the area. starts: points of each surface. Throws SolveFailure, Aborted.
double MeasureCycles(const std::vector<Surface>& surfaces,
  const std::vector<std::vector<int>>& starts, const std::vector<std::array<int, 3>>& triples,
  const PositionMap& map, const Progress& progress = {});

} // namespace shape
