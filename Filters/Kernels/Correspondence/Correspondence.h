#pragma once

#include "Base/Progress.h"
#include "Correspondence/CorrespondenceOptions.h"
#include "Correspondence/Evaluate/SurfaceMapFacts.h"
#include "Correspondence/Landmarks/AutomaticLandmarks.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Pair/SurfacePart.h"
#include "Mesh/Surface.h"

namespace shape
{

struct CorrespondenceResult
{
  /// A row for each point. A point that no triangle uses is mapped like the nearest point that one
  /// uses.
  SurfaceMaps Maps;
  Landmarks Used;                 ///< points of A and B: the given landmarks, or the automatic ones
  bool Found = false;             ///< whether the landmarks were found automatically
  AutomaticLandmarksResult Start; ///< the result of FindLandmarks, if they were
  SurfacePart Part;     ///< which surface is a part of the other one, and the scale between them
  int CoarsePoints = 0; ///< points of the larger surface that the method was run on
  int Iterations = 0;   ///< ReversibleHarmonic, on the coarse surfaces; 0 if it returned its start
  double CouplingDistortion = -1.0; ///< GromovWasserstein: see GromovWassersteinResult::Distortion
  double CouplingError = -1.0;      ///< GromovWasserstein: see GromovWassersteinResult::Error
  SurfaceMapFacts Facts;
};

/**
 * Computes corresponding points of two surfaces, in both directions, by one of seven methods. The
 * header of each method says for which surfaces it is suitable. Without landmarks, those of
 * FindLandmarks are used, which needs surfaces of one component; they are not pinned.
 * CommonOrbifold uses the first four of them.
 *
 * a, b: consistently oriented 2-manifolds, facing outwards if they are closed. Points that no
 * triangle uses are ignored. Throws InvalidInput, SolveFailure, Aborted.
 */
CorrespondenceResult ComputeCorrespondence(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const CorrespondenceOptions& options = {},
  const Progress& progress = {});

} // namespace shape
