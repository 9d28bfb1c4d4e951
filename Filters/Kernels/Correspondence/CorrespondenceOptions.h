#pragma once

#include "Correspondence/CommonBase/CommonBaseMap.h"
#include "Correspondence/Conformal/BlendedIntrinsic.h"
#include "Correspondence/Conformal/MoebiusVoting.h"
#include "Correspondence/Functional/FunctionalMap.h"
#include "Correspondence/Functional/HeatKernelMap.h"
#include "Correspondence/Reversible/ReversibleHarmonic.h"
#include "Correspondence/Transport/GromovWasserstein.h"

namespace shape
{

struct CorrespondenceOptions
{
  enum class MethodType
  {
    ReversibleHarmonic = 0, ///< shape::ComputeReversibleHarmonicMap: for different shapes
    FunctionalMap = 1,      ///< shape::ComputeFunctionalMap: for bent copies of one shape
    GromovWasserstein = 2,  ///< shape::ComputeGromovWassersteinMap: compares sample distances
    HeatKernel = 3,         ///< shape::ComputeHeatKernelMap: needs only one landmark
    BlendedIntrinsic = 4,   ///< shape::ComputeBlendedIntrinsicMap: for genus 0
    CommonSphere = 5,       ///< shape::MapThroughSphere: one to one; for closed surfaces of genus 0
    /// shape::MapThroughOrbifold, or from five landmarks on shape::MapThroughHyperbolicOrbifold:
    /// the same, with exact landmarks
    CommonOrbifold = 6,
    WeightedAverages = 7, ///< shape::MapByWeightedAverages: smooth, from many landmarks
    GeneralizedMDS = 8,   ///< shape::ComputeGeneralizedMDS: changes distances least; any genus
    CommonBase = 9        ///< shape::MapThroughBase: one to one; for closed surfaces of any genus
  };
  MethodType Method = MethodType::ReversibleHarmonic;
  /// The initial maps of ReversibleHarmonic.
  enum class StartType
  {
    FunctionalMap = 0, ///< the functional map from the same landmarks
    LandmarkCells = 1  ///< each point goes to the partner of its nearest landmark
  };
  StartType Start = StartType::FunctionalMap;
  /// ReversibleHarmonic: whether each given landmark is mapped exactly to its partner.
  bool PinLandmarks = true;
  /// How landmarks are found if none are given.
  enum class FinderType
  {
    Distances = 0,   ///< FindLandmarks: distances between the tips of extremities; any genus
    MoebiusVotes = 1 ///< VoteByMoebiusMaps: up to 12 pairs of samples; genus 0, complete
  };
  FinderType FindLandmarksBy = FinderType::Distances;
  int Rank = 0;                 ///< Distances: AutomaticLandmarksOptions::Rank
  int MaximumIterations = 100;  ///< ReversibleHarmonic: maximum number of iterations; >= 1
  int NumberOfEigenpairs = 120; ///< FunctionalMap: maximum number for each surface; >= 10
  int Samples = 500;            ///< GromovWasserstein: samples of each surface; >= 10
  /// GromovWasserstein: the coupling of the samples.
  EntropicCouplingOptions Coupling;
  PairFeatures Features; ///< GromovWasserstein: what corresponding points should share
  /// GromovWasserstein: eigenpairs that extend the coupling to all points; >= 2.
  int CouplingEigenpairs = 60;
  /// GromovWasserstein without given landmarks: the landmarks from which the coupling starts.
  enum class CouplingStartType
  {
    Best = 0,  ///< both of FindLandmarks' maps; the coupling with the smaller distortion is used
    Found = 1, ///< FindLandmarks' best map
    Rival = 2  ///< FindLandmarks' rival, such as the other one of two symmetric maps
  };
  CouplingStartType CouplingStart = CouplingStartType::Best;
  int ScalingSamples = 100; ///< GeneralizedMDS: samples of each surface; >= 8
  int ScalingStarts = 8;    ///< GeneralizedMDS: starts that are optimised; >= 1
  /// Whether the maps are compared with distances along the surfaces (MeasureGromovHausdorff). It
  /// is always done for GeneralizedMDS.
  bool CompareDistances = false;
  int DistanceSamples = 50; ///< CompareDistances: samples of each surface; >= 2
  /// Which surface is a part of the other one. FunctionalMap and HeatKernel map the part into the
  /// other surface. If ReversibleHarmonic starts from this map, it returns the map unchanged.
  /// Iterations would spread the part over the whole other surface. The other methods treat both
  /// surfaces as complete.
  enum class PartType
  {
    Automatic = 0, ///< decided by FindPart if landmarks are given, else by FindLandmarks
    None = 1,      ///< both surfaces are complete
    SurfaceA = 2,
    SurfaceB = 3
  };
  PartType Part = PartType::Automatic;
  /// A surface with more points than this is matched on a coarse copy (CoarsePair) with about this
  /// many points. The maps are then transferred to the given surfaces. ReversibleHarmonic uses two
  /// fifths of the larger surface's points, but at least 2000 and never more than CoarsePoints. It
  /// then refines the maps on the given surfaces. CommonSphere, CommonOrbifold and CommonBase never
  /// coarsen. GeneralizedMDS never uses more than 600. If CoarsePoints is 0, no surface is
  /// coarsened; otherwise it is >= 100.
  int CoarsePoints = 8000;
  /// Whether the matrix of the map is computed (CorrespondenceResult::Matrix), by any method. It
  /// takes the eigenfunctions of the given surfaces.
  bool FunctionalMatrix = false;

  ///@{
  /// Further options of the methods. Those above replace the options of the same name here, and
  /// Functional.Refinement.Last.
  FunctionalMapOptions Functional;
  ReversibleHarmonicOptions Harmonic;
  HeatKernelMapOptions Heat;
  BlendedIntrinsicOptions Blended;
  CommonBaseOptions Base;
  MoebiusVotingOptions Voting;
  ///@}

  /// Whether the method computes a functional map that Functional.Guide guides: FunctionalMap, and
  /// ReversibleHarmonic if it starts from one.
  bool UsesGuide() const
  {
    return this->Method == MethodType::FunctionalMap ||
      (this->Method == MethodType::ReversibleHarmonic && this->Start == StartType::FunctionalMap);
  }
  /// Whether BlendedIntrinsic blends the maps of triples of feature points: then no landmarks are
  /// found.
  bool UsesTriplets() const
  {
    return this->Method == MethodType::BlendedIntrinsic &&
      this->Blended.CandidatesFrom == BlendedIntrinsicOptions::CandidatesType::Triplets;
  }
  /// Whether the guide takes the place of landmarks: then none are found automatically.
  bool IsGuided() const
  {
    const FunctionalGuide& guide = this->Functional.Guide;
    return this->UsesGuide() &&
      (guide.Matrix.size() > 0 ||
        (this->Functional.Use != FunctionalMapOptions::DescriptorType::BuiltIn &&
          guide.DescriptorsOfA.cols() > 0));
  }
};

} // namespace shape
