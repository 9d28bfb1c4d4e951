#pragma once

#include "Correspondence/CorrespondenceOptions.h"
#include "Correspondence/Landmarks/AutomaticLandmarks.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Pair/SurfacePart.h"
#include "Correspondence/Transport/SampledCoupling.h"

namespace shape
{

/// What CorrespondenceResult tells about landmarks, under the same names.
struct LandmarkSearch
{
  Landmarks Pairs;
  AutomaticLandmarksResult Start;
  SurfacePart Part;
  int VotingMaps = 0;
  double VotingConfidence = -1.0;
  SampledCoupling Votes;
};

/// Finds landmarks if `find` is true, by the way that the options name; else Pairs are `landmarks`.
/// Decides which surface is a part of the other one. Throws InvalidInput, SolveFailure, Aborted.
LandmarkSearch SearchLandmarks(const Surface& a, const Surface& b, const Landmarks& landmarks,
  bool find, const CorrespondenceOptions& options, const Progress& progress);

} // namespace shape
