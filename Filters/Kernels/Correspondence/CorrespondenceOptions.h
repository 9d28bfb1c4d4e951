#pragma once

namespace shape
{

struct CorrespondenceOptions
{
  enum class MethodType
  {
    ReversibleHarmonic = 0, ///< shape::ComputeReversibleHarmonicMap: for different shapes
    FunctionalMap = 1,      ///< shape::ComputeFunctionalMap: for bent copies of one shape
    GromovWasserstein = 2,  ///< shape::ComputeGromovWassersteinMap: by distances between samples
    HeatKernel = 3,         ///< shape::ComputeHeatKernelMap: from one landmark
    BlendedIntrinsic = 4,   ///< shape::ComputeBlendedIntrinsicMap: genus 0
    CommonSphere = 5,       ///< shape::MapThroughSphere: closed, genus 0, exactly one to one
    CommonOrbifold = 6      ///< shape::MapThroughOrbifold: likewise, with three or four landmarks
  };
  MethodType Method = MethodType::ReversibleHarmonic;
  /// The initial maps of ReversibleHarmonic.
  enum class StartType
  {
    FunctionalMap = 0, ///< the functional map from the same landmarks
    LandmarkCells = 1  ///< each point goes to the partner of its nearest landmark
  };
  StartType Start = StartType::FunctionalMap;
  /// ReversibleHarmonic: whether given landmarks go to their partners exactly.
  bool PinLandmarks = true;
  int MaximumIterations = 100;  ///< ReversibleHarmonic; >= 1
  int NumberOfEigenpairs = 120; ///< FunctionalMap: maximum for each surface; >= 10
  int Samples = 500;            ///< GromovWasserstein: samples of each surface; >= 10
  /// Which surface is a part of the other one. FunctionalMap maps the part into the other surface.
  /// ReversibleHarmonic returns that map, since its iterations would spread the part over the other
  /// surface. The other methods treat both surfaces as complete.
  enum class PartType
  {
    Automatic = 0, ///< as FindPart decides from the given landmarks, or as FindLandmarks decides
    None = 1,
    SurfaceA = 2,
    SurfaceB = 3
  };
  PartType Part = PartType::Automatic;
  /// Surfaces with more points are matched on coarse copies (CoarsePair) with about this many
  /// points, and the maps are transferred to the given surfaces. ReversibleHarmonic uses two fifths
  /// of the surface's points if that is fewer, but at least 2000, and refines the maps.
  /// CommonSphere and CommonOrbifold never coarsen. 0: never coarsen; otherwise >= 100.
  int CoarsePoints = 8000;
};

} // namespace shape
