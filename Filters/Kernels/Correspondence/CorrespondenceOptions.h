#pragma once

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
  /// ReversibleHarmonic returns that map: its iterations would spread the part. The other methods
  /// take both for whole.
  enum class PartType
  {
    Automatic = 0, ///< as FindPart tells from the landmarks, or FindLandmarks if it finds them
    None = 1,
    SurfaceA = 2,
    SurfaceB = 3
  };
  PartType Part = PartType::Automatic;
  /// Surfaces of more points are matched on coarse ones (CoarsePair) of about as many, and the maps
  /// carried over; ReversibleHarmonic uses two fifths of the points, if that is less but at least
  /// 2000, and refines the maps. CommonSphere and CommonOrbifold never coarsen. 0: never; else >=
  /// 100.
  int CoarsePoints = 8000;
};

} // namespace shape
