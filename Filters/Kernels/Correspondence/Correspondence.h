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
  SurfaceMaps Maps; ///< a row for each point, one that no triangle uses goes with the nearest used
  Landmarks Used;   ///< points of A and B: those given, or found
  bool Found = false;               ///< whether landmarks were found, not given
  AutomaticLandmarksResult Start;   ///< where they were
  SurfacePart Part;                 ///< what is a part, and at what scale
  int CoarsePoints = 0;             ///< of the larger surface that the method worked on
  int Iterations = 0;               ///< of ReversibleHarmonic, on these; 0 if it ended at its start
  double CouplingDistortion = -1.0; ///< of GromovWasserstein: GromovWassersteinResult's Distortion
  double CouplingError = -1.0;      ///< and its Error
  SurfaceMapFacts Facts;
};

/**
 * Which point of one surface corresponds to which point of another one, both ways, by one of
 * seven methods; each says in its header what surfaces it is for. Without landmarks those of
 * FindLandmarks are used, on surfaces of one component; they are not pinned. CommonOrbifold
 * takes the first four of these.
 *
 * a, b: consistently oriented 2-manifolds, facing outwards if they are closed; points that no
 * triangle uses are left aside. Throws InvalidInput, SolveFailure, Aborted.
 */
CorrespondenceResult ComputeCorrespondence(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const CorrespondenceOptions& options = {},
  const Progress& progress = {});

} // namespace shape
