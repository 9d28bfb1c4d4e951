#pragma once

#include "Base/Progress.h"
#include "Correspondence/Landmarks/FeaturedSurface.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Pair/ZoomOut.h"
#include "Mesh/Surface.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

// The steps of FindLandmarks (AutomaticLandmarks.h), for many pairs of the same surfaces.

struct AutomaticLandmarksOptions;

/// A surface prepared once, to be matched with many others.
struct MatchedSurface
{
  shape::Surface Surface;
  FeaturedSurface Featured;
  LaplaceEigenpairs Spectrum; ///< of the surface scaled to area 1
};

/// Prepares a surface that RequireConnected accepts. pairs: number of eigenpairs; there are fewer
/// if the surface has fewer points. Throws InvalidInput, SolveFailure, Aborted.
MatchedSurface PrepareMatching(const Surface& surface, int pairs,
  const AutomaticLandmarksOptions& options, const Progress& progress = {});

/// One of the different maps that FindLandmarks compares.
struct LandmarkCandidate
{
  Landmarks Pairs; ///< the corresponding features
  ///@{
  /// See AutomaticLandmarksResult.
  double Distortion = 0.0, Error = 0.0;
  ///@}
  FunctionalMaps Maps; ///< of 60 eigenfunctions, or of all if a surface has fewer
};

/// Finds the maps of two complete surfaces that FindLandmarks would offer by Rank, the best first;
/// none if no three features agree. Throws Aborted.
std::vector<LandmarkCandidate> FindLandmarkCandidates(const MatchedSurface& a,
  const MatchedSurface& b, const AutomaticLandmarksOptions& options, const Progress& progress = {});

} // namespace shape
