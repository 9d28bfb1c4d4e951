#pragma once

#include "Base/Progress.h"
#include "Correspondence/Evaluate/SurfaceMapFacts.h"
#include "Correspondence/Landmarks/AutomaticLandmarks.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Pair/SurfacePart.h"
#include "Mesh/Mesh.h"

namespace shape
{

struct CorrespondenceOptions
{
  enum class MethodType
  {
    ReversibleHarmonic = 0, ///< shape::ComputeReversibleHarmonicMap: for different shapes
    FunctionalMap = 1,      ///< shape::ComputeFunctionalMap: for one shape that is bent
    GromovWasserstein = 2,  ///< shape::ComputeGromovWassersteinMap: by distances between samples
    HeatKernel = 3,         ///< shape::ComputeHeatKernelMap: from one landmark
    BlendedIntrinsic = 4,   ///< shape::ComputeBlendedIntrinsicMap: genus 0
    CommonSphere = 5,       ///< shape::MapThroughSphere: closed, genus 0, exactly one to one
    CommonOrbifold = 6      ///< shape::MapThroughOrbifold: the same, three or four landmarks
  };
  MethodType Method = MethodType::ReversibleHarmonic;
  /// What ReversibleHarmonic starts from.
  enum class StartType
  {
    FunctionalMap = 0, ///< of these landmarks
    LandmarkCells = 1  ///< each point at the partner of its nearest landmark
  };
  StartType Start = StartType::FunctionalMap;
  bool PinLandmarks = true;    ///< ReversibleHarmonic: given landmarks go to their partners exactly
  int MaximumIterations = 100; ///< of ReversibleHarmonic; >= 1
  int NumberOfEigenpairs = 120; ///< FunctionalMap, at most: of each surface; >= 10
  int Samples = 500;            ///< of each surface, GromovWasserstein compares; >= 10
  /// Which surface is a part of the other one. FunctionalMap maps a part into the whole, and
  /// ReversibleHarmonic from there ends at that: its iterations would spread the part. The other
  /// methods take both for whole.
  enum class PartType
  {
    Automatic = 0, ///< what FindPart says of the landmarks, or FindLandmarks where it finds them
    None = 1,
    SurfaceA = 2,
    SurfaceB = 3
  };
  PartType Part = PartType::Automatic;
  /// Surfaces of more points are mapped on coarse ones (CoarsePair) of about so many, and the maps
  /// carried over; ReversibleHarmonic of two fifths as many as there are, where that is less but at
  /// least 2000, and refined; not CommonSphere and CommonOrbifold. 0: never; else >= 100.
  int CoarsePoints = 8000;
};

struct CorrespondenceResult
{
  SurfaceMaps Maps; ///< a row for each point, one that no triangle uses goes with the nearest used
  Landmarks Used;   ///< points of A and B: those given, or found
  bool Found = false;             ///< whether landmarks were found, not given
  AutomaticLandmarksResult Start; ///< where they were
  SurfacePart Part;               ///< what is a part, and at what scale
  int CoarsePoints = 0;           ///< of the larger surface that the method worked on
  int Iterations = 0; ///< of ReversibleHarmonic, on these; 0 where it ended at its start
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
 * a, b: consistently oriented 2-manifolds, facing outwards where they are closed; points that no
 * triangle uses are left aside. Throws InvalidInput, SolveFailure, Aborted.
 */
CorrespondenceResult ComputeCorrespondence(const Mesh& a, const Mesh& b, const Landmarks& landmarks,
  const CorrespondenceOptions& options = {}, const Progress& progress = {});

} // namespace shape
