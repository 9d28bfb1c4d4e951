#include "Correspondence/Correspondence.h"

#include "Base/Errors.h"
#include "Correspondence/Averages/WeightedAverages.h"
#include "Correspondence/Conformal/BlendedIntrinsic.h"
#include "Correspondence/Conformal/HyperbolicMap.h"
#include "Correspondence/Conformal/OrbifoldMap.h"
#include "Correspondence/Conformal/SphereCommonDomain.h"
#include "Correspondence/Evaluate/AreaChange.h"
#include "Correspondence/Functional/FunctionalMap.h"
#include "Correspondence/Functional/HeatKernelMap.h"
#include "Correspondence/Functional/PartialFunctionalMap.h"
#include "Correspondence/Landmarks/LandmarkCells.h"
#include "Correspondence/Pair/CoarsePair.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Correspondence/Private/CompactSurface.h"
#include "Correspondence/Private/LandmarkSearch.h"
#include "Correspondence/Private/MethodInput.h"
#include "Correspondence/Private/MethodOptions.h"
#include "Correspondence/Reversible/ReversibleHarmonic.h"
#include "Correspondence/Transport/GeneralizedMDS.h"
#include "Correspondence/Transport/GromovWasserstein.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Options = CorrespondenceOptions;

bool HasFewer(const CompactSurface& one, const CompactSurface& other)
{
  return one.Surface.Points().rows() < other.Surface.Points().rows();
}

/// Of the landmarks that were found, only the first four are used: a wrong one does more harm than
/// further ones do good.
SurfaceMaps ThroughOrbifold(
  const Surface& a, const Surface& b, Landmarks landmarks, bool found, const Progress& progress)
{
  constexpr std::size_t maximum = 4;
  if (found && landmarks.size() > maximum)
  {
    landmarks.resize(maximum);
  }
  if (landmarks.size() > maximum)
  {
    return MapThroughHyperbolicOrbifold(
      a, PointsOf(landmarks, 0), b, PointsOf(landmarks, 1), progress);
  }
  // Of the types with as many cones, these depend least on the mesh (MapThroughOrbifold).
  const OrbifoldType type =
    landmarks.size() == maximum ? OrbifoldType::Rectangle : OrbifoldType::Rhombus;
  OrbifoldMap map =
    MapThroughOrbifold(a, PointsOf(landmarks, 0), b, PointsOf(landmarks, 1), type, progress);
  return { std::move(map.AToB), std::move(map.BToA) };
}

/// Whether landmarks must be found.
bool NeedsLandmarks(const Landmarks& landmarks, const Options& options)
{
  return landmarks.empty() && !options.IsGuided() &&
    options.Method != Options::MethodType::GeneralizedMDS && !options.UsesTriplets();
}

/// The maps of a part and the full surface. map: takes the part, the other one, landmarks, scale.
template <typename Map>
SurfaceMaps MapPart(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const SurfacePart& part, const Map& map)
{
  if (part.Which == SurfacePart::WhichType::SurfaceA)
  {
    return map(a, b, landmarks, part.Scale);
  }
  Landmarks turned;
  for (const auto& [pointA, pointB] : landmarks)
  {
    turned.push_back({ pointB, pointA });
  }
  SurfaceMaps maps = map(b, a, turned, 1.0 / part.Scale);
  return { std::move(maps.BToA), std::move(maps.AToB) };
}

/// The functional map of two surfaces, one of which may be a part of the other one.
SurfaceMaps Functional(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const Options& options, const SurfacePart& part, const Progress& progress)
{
  if (part.Which != SurfacePart::WhichType::None)
  {
    PartialFunctionalMapOptions partial;
    partial.Eigenpairs = options.NumberOfEigenpairs;
    return MapPart(a, b, landmarks, part,
      [&](const Surface& own, const Surface& full, const Landmarks& pairs, double scale)
      { return ComputePartialFunctionalMap(own, full, pairs, scale, partial, progress); });
  }
  FunctionalMapOptions whole = options.Functional;
  whole.Refinement.Last = options.NumberOfEigenpairs;
  return ComputeFunctionalMap(a, b, landmarks, whole, progress);
}

/// The same for the heat kernel map.
SurfaceMaps HeatKernel(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const Options& options, const SurfacePart& part, const Progress& progress)
{
  if (part.Which == SurfacePart::WhichType::None)
  {
    return ComputeHeatKernelMap(a, b, landmarks, options.Heat, progress);
  }
  return MapPart(a, b, landmarks, part,
    [&](const Surface& own, const Surface& full, const Landmarks& pairs, double scale)
    { return ComputePartialHeatKernelMap(own, full, pairs, scale, options.Heat, progress); });
}

/// A part is located by landmarks alone.
void RequireNoGuide(const SurfacePart& part, const Options& options)
{
  if (part.Which != SurfacePart::WhichType::None && options.IsGuided())
  {
    throw InvalidInput(std::string(part.Which == SurfacePart::WhichType::SurfaceA
                           ? "SurfaceA is treated as a part of SurfaceB"
                           : "SurfaceB is treated as a part of SurfaceA") +
      ", which is located by landmarks alone; set Part to None, or leave out FunctionalMap, "
      "DescriptorArrays and RegionArray");
  }
}

/// Returns how many points of a surface the method needs; 0: all.
int EnoughPoints(const Surface& surface, const Options& options)
{
  switch (options.Method)
  {
    case Options::MethodType::CommonSphere:
    case Options::MethodType::CommonOrbifold:
    case Options::MethodType::CommonBase:
      return 0; // only maps of the given surfaces are one to one
    case Options::MethodType::ReversibleHarmonic:
    {
      // Coarse maps are refined: two fifths of the points give equal quality in half the time.
      constexpr int minimum = 2000;
      const auto points = static_cast<int>(surface.Points().rows());
      return std::min(options.CoarsePoints, std::max(minimum, points / 5 * 2));
    }
    case Options::MethodType::GeneralizedMDS:
    {
      constexpr int enough = 600; // the time grows with their cube
      return options.CoarsePoints == 0 ? 0 : std::min(options.CoarsePoints, enough);
    }
    default:
      return options.CoarsePoints;
  }
}

/// The landmarks from which the couplings start, of those found and their rival.
std::vector<Landmarks> CouplingStarts(
  const Landmarks& found, const Landmarks& rival, Options::CouplingStartType start)
{
  using Start = Options::CouplingStartType;
  if (start == Start::Rival && rival.empty())
  {
    throw InvalidInput("no map contradicts the landmarks that were found, so there is no rival to "
                       "start from; set CouplingStart to Best or Found");
  }
  std::vector<Landmarks> starts;
  if (start != Start::Rival)
  {
    starts.push_back(found);
  }
  if (start != Start::Found && !rival.empty())
  {
    starts.push_back(rival);
  }
  return starts;
}

void SetOnFine(const CoarsePair& pair, SampledCoupling& coupling)
{
  for (int& sample : coupling.SamplesOfA)
  {
    sample = pair.FinePointOfA(sample);
  }
  for (int& sample : coupling.SamplesOfB)
  {
    sample = pair.FinePointOfB(sample);
  }
}

void SetOnFine(const CoarsePair& pair, BlendedIntrinsicResult& blended)
{
  blended.ConfidenceOfA = pair.ValuesOnFineA(blended.ConfidenceOfA);
  blended.ConfidenceOfB = pair.ValuesOnFineB(blended.ConfidenceOfB);
  blended.TriplesOfA =
    blended.TriplesOfA.unaryExpr([&](int point) { return pair.FinePointOfA(point); }).eval();
  blended.TriplesOfB =
    blended.TriplesOfB.unaryExpr([&](int point) { return pair.FinePointOfB(point); }).eval();
}

void RequireRows(const Eigen::MatrixXd& features, const Surface& surface, const std::string& name)
{
  if (features.rows() != surface.Points().rows())
  {
    throw InvalidInput("there are features of " + std::to_string(features.rows()) +
      " points, but " + name + " has " + std::to_string(surface.Points().rows()) +
      "; give a row for each point");
  }
}

void Renumber(std::vector<int>& indices, const std::vector<int>& points)
{
  for (int& index : indices)
  {
    index = points[index];
  }
}

/// Below this ComputeAreaChange, a functional map is right at large scales. The first iterations of
/// ReversibleHarmonic, which move maps farthest, would let it slide, since all conformal maps have
/// nearly the same energy. (39 of 40 pairs in poses have at most 0.053, and 5 of 6 stretched ones
/// at least 0.09.)
constexpr double Isometric = 0.07;

/// Computes the maps of the fine surfaces. landmarks: of the coarse ones; on return, those used.
SurfaceMaps Find(const CoarsePair& pair, Landmarks& landmarks, const Options& options,
  CorrespondenceResult& result, const Progress& whole)
{
  const Surface &a = pair.A(), &b = pair.B();
  const Progress progress = whole.Part(0.0, 0.9),
                 lift = whole.Part(0.9, 1.0, "interpolating the maps");
  switch (options.Method)
  {
    case Options::MethodType::FunctionalMap:
      return pair.OnFine(Functional(a, b, landmarks, options, result.Part, progress), lift);
    case Options::MethodType::GromovWasserstein:
    {
      GromovWassersteinOptions own;
      own.Samples = options.Samples;
      own.Eigenpairs = options.CouplingEigenpairs;
      own.Coupling = options.Coupling;
      own.Features = OnCoarse(options.Features, pair);
      // Landmarks that were found are a guess: they are starts of the coupling, which may correct
      // them.
      if (result.Found)
      {
        own.Starts = CouplingStarts(landmarks, result.Start.Rival, options.CouplingStart);
      }
      GromovWassersteinResult coupled =
        ComputeGromovWassersteinMap(a, b, result.Found ? Landmarks() : landmarks, own, progress);
      result.CouplingDistortion = coupled.Distortion;
      result.CouplingError = coupled.Error;
      result.FeatureCost = coupled.FeatureCost;
      result.Coupling = std::move(coupled.Coupling);
      SetOnFine(pair, result.Coupling);
      if (result.Found)
      {
        landmarks = coupled.Start;
      }
      return pair.OnFine(coupled.Maps, lift);
    }
    case Options::MethodType::HeatKernel:
      return pair.OnFine(HeatKernel(a, b, landmarks, options, result.Part, progress), lift);
    case Options::MethodType::BlendedIntrinsic:
    {
      result.Blended = ComputeBlendedIntrinsicMap(a, b, landmarks, options.Blended, progress);
      SetOnFine(pair, *result.Blended);
      return pair.OnFine(std::exchange(result.Blended->Maps, {}), lift);
    }
    case Options::MethodType::CommonSphere:
    {
      SphereCommonDomainResult common =
        MapThroughSphere(a, PointsOf(landmarks, 0), b, PointsOf(landmarks, 1), {}, progress);
      result.SphereA = std::move(common.SphereA);
      result.SphereB = std::move(common.SphereB);
      return { std::move(common.AToB), std::move(common.BToA) };
    }
    case Options::MethodType::CommonOrbifold:
      return ThroughOrbifold(a, b, landmarks, result.Found, progress);
    case Options::MethodType::WeightedAverages:
      return pair.OnFine(MapByWeightedAverages(a, b, landmarks, {}, progress), lift);
    case Options::MethodType::GeneralizedMDS:
    {
      GeneralizedMDSOptions own;
      own.Samples = options.ScalingSamples;
      own.Starts = options.ScalingStarts;
      return pair.OnFine(ComputeGeneralizedMDS(a, b, landmarks, own, progress).Maps, lift);
    }
    case Options::MethodType::CommonBase:
    {
      result.Base = result.Handles
        ? MapByHandles(a, b, *result.Handles, landmarks, options.Base, progress)
        : MapThroughBase(a, b, landmarks, options.Base, progress);
      return std::move(result.Base->Maps);
    }
    case Options::MethodType::ReversibleHarmonic:
      break;
  }
  const bool isFunctional = options.Start == Options::StartType::FunctionalMap;
  const double started = isFunctional ? 0.6 : 0.1; // share of the time
  const Progress first = whole.Part(0.0, started);
  const SurfaceMaps start = isFunctional ? Functional(a, b, landmarks, options, result.Part, first)
                                         : MapByLandmarkCells(a, b, landmarks, first);
  if (isFunctional && result.Part.Which != SurfacePart::WhichType::None)
  {
    return pair.OnFine(start, lift); // iterations would spread the part over the other surface
  }
  ReversibleHarmonicOptions own = options.Harmonic;
  own.MaximumIterations = options.MaximumIterations;
  // Landmarks that were found may be inexact, so they are not pinned.
  own.PinLandmarks = options.PinLandmarks && !result.Found;
  if (isFunctional && ComputeAreaChange(a, b, start) < Isometric)
  {
    own.FirstIteration = 1 + 3 * own.AlphaSteps / 8;
  }
  ReversibleHarmonicResult harmonic =
    RefineReversibleHarmonicMap(pair, start, landmarks, own, whole.Part(started, 1.0));
  result.Iterations = static_cast<int>(harmonic.Energies.size());
  return std::move(harmonic.Maps);
}

} // namespace

// 1. Remove the points that no triangle uses.
// 2. Without landmarks, find some on coarse versions of the surfaces.
// 3. Coarsen both surfaces to the size that the method needs, and keep the landmarks as points.
// 4. With given landmarks, decide whether one surface is a part of the other one
// (SearchLandmarks).
// 5. Compute the maps by the method, and bring them to the given surfaces (Find).
// 6. Evaluate the maps, and number everything as given.
CorrespondenceResult ComputeCorrespondence(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const CorrespondenceOptions& options, const Progress& progress)
{
  RequireMethodOptions(options);
  RequireMethodInput(a, b, landmarks, options);
  const CompactSurface one(a, "SurfaceA"), two(b, "SurfaceB");
  CorrespondenceResult result;
  result.GenusOfA = ComputeGenus(a.Topology());
  result.GenusOfB = ComputeGenus(b.Topology());
  Landmarks own;
  for (const auto& [pointA, pointB] : landmarks)
  {
    if (one.PositionOf(pointA) < 0 || two.PositionOf(pointB) < 0)
    {
      throw InvalidInput("landmark " + std::to_string(own.size()) +
        " is at a point that no triangle uses; put it on the surface");
    }
    own.push_back({ one.PositionOf(pointA), two.PositionOf(pointB) });
  }
  const bool find = NeedsLandmarks(own, options);
  result.Found = find;
  const bool onHandles =
    find && options.Method == Options::MethodType::CommonBase && result.GenusOfA > 0;
  const double searched = find ? 0.15 : 0.0, found = onHandles ? 0.6 : searched; // shares of time
  // A guide that is not used is not prepared either.
  Options used = options;
  for (CurvePair& curve : used.Base.Curves)
  {
    curve = Renumber(curve, one.PositionOf, two.PositionOf);
  }
  FunctionalGuide& guide = used.Functional.Guide;
  guide = options.UsesGuide() ? AtPoints(guide, one.Points, two.Points) : FunctionalGuide();
  if (guide.Matrix.size() > 0)
  {
    guide = WithEigenbases(guide, one.Surface, two.Surface, progress.Part(0.0, found));
  }
  if (find)
  {
    const CoarsePair pair(one.Surface, two.Surface, {}, options.CoarsePoints,
      progress.Part(0.0, 0.05, "coarsening the surfaces"));
    LandmarkSearch search = SearchLandmarks(
      pair.A(), pair.B(), own, find, options, progress.Part(0.05, searched, "finding landmarks"));
    own = pair.OnFine(search.Pairs);
    if (onHandles)
    {
      result.Handles = FindHandleLandmarks(one.Surface, two.Surface, own,
        progress.Part(searched, found, "finding landmarks on handles"));
      own = result.Handles->Candidates.front().Pairs;
    }
    result.Start = std::move(search.Start);
    result.Part = search.Part;
    result.VotingMaps = search.VotingMaps;
    result.VotingConfidence = search.VotingConfidence;
    result.Coupling = std::move(search.Votes);
    result.Start.Pairs = pair.OnFine(result.Start.Pairs);
    result.Start.Rival = pair.OnFine(result.Start.Rival);
    SetOnFine(pair, result.Coupling);
    result.Congruent = FindCongruence(pair.A(), pair.B());
  }
  Landmarks kept = own;
  kept.insert(kept.end(), result.Start.Rival.begin(), result.Start.Rival.end());
  for (const Landmarks& curve : guide.Curves)
  {
    kept.insert(kept.end(), curve.begin(), curve.end());
  }
  // A second coarsening: the landmarks are known now and must survive, and the number of points is
  // that of the method.
  const CoarsePair pair(one.Surface, two.Surface, kept,
    EnoughPoints(std::max(one, two, HasFewer).Surface, options),
    progress.Part(found, found + 0.05, "coarsening the surfaces"));
  result.CoarsePoints =
    static_cast<int>(std::max(pair.A().Points().rows(), pair.B().Points().rows()));
  own = pair.OnCoarse(own);
  result.Start.Rival = pair.OnCoarse(result.Start.Rival);
  if (!find)
  {
    result.Part = SearchLandmarks(pair.A(), pair.B(), own, find, options,
      progress.Part(found + 0.05, found + 0.1, "comparing the landmarks"))
                    .Part;
  }
  RequireNoGuide(result.Part, options);
  guide = OnCoarse(guide, pair);
  if (options.Features.OfA.cols() > 0)
  {
    RequireRows(options.Features.OfA, a, "SurfaceA");
    RequireRows(options.Features.OfB, b, "SurfaceB");
    used.Features.OfA = options.Features.OfA(one.Points, Eigen::all);
    used.Features.OfB = options.Features.OfB(two.Points, Eigen::all);
  }
  const bool compare =
    options.CompareDistances || options.Method == Options::MethodType::GeneralizedMDS;
  const double mapped = compare ? 0.6 : options.FunctionalMatrix ? 0.8 : 0.95; // share of the time
  const SurfaceMaps maps =
    Find(pair, own, used, result, progress.Part(found + 0.1, mapped, "mapping the surfaces"));
  result.Start.Rival = pair.OnFine(result.Start.Rival);
  const auto asGiven = [&](Landmarks found)
  {
    for (auto& [pointA, pointB] : found)
    {
      pointA = one.Points[pointA];
      pointB = two.Points[pointB];
    }
    return found;
  };
  result.Used = asGiven(pair.OnFine(own));
  result.Start.Pairs = asGiven(result.Start.Pairs);
  result.Start.Rival = asGiven(result.Start.Rival);
  if (result.Handles)
  {
    for (HandleCandidate& candidate : result.Handles->Candidates)
    {
      candidate.Pairs = asGiven(candidate.Pairs);
    }
    for (HandleLoop& loop : result.Handles->LoopsOfA)
    {
      Renumber(loop.Points, one.Points);
    }
  }
  Renumber(result.Coupling.SamplesOfA, one.Points);
  Renumber(result.Coupling.SamplesOfB, two.Points);
  result.Facts = EvaluateMaps(one.Surface, two.Surface, maps);
  if (compare)
  {
    GromovHausdorffOptions distances;
    distances.Samples = options.DistanceSamples;
    result.Distances = MeasureGromovHausdorff(one.Surface, two.Surface, maps, distances,
      progress.Part(mapped, 0.99, "comparing distances"));
  }
  result.Maps = { one.Expand(maps.AToB), two.Expand(maps.BToA) };
  result.SphereA = one.Expand(result.SphereA);
  result.SphereB = two.Expand(result.SphereB);
  if (auto& blended = result.Blended)
  {
    blended->ConfidenceOfA = one.Expand(blended->ConfidenceOfA);
    blended->ConfidenceOfB = two.Expand(blended->ConfidenceOfB);
    blended->TriplesOfA =
      blended->TriplesOfA.unaryExpr([&](int point) { return one.Points[point]; }).eval();
    blended->TriplesOfB =
      blended->TriplesOfB.unaryExpr([&](int point) { return two.Points[point]; }).eval();
  }
  if (result.Base)
  {
    result.Base->PatchesOfA = one.Expand(result.Base->PatchesOfA.cast<double>()).cast<int>();
    result.Base->PatchesOfB = two.Expand(result.Base->PatchesOfB.cast<double>()).cast<int>();
  }
  if (options.FunctionalMatrix)
  {
    const std::size_t points = std::min(one.Points.size(), two.Points.size());
    result.Matrix = ComputeFunctionalMatrix(a, b, result.Maps.BToA,
      std::min(options.NumberOfEigenpairs, static_cast<int>(points)),
      progress.Part(compare ? 0.99 : mapped, 1.0));
  }
  progress(1.0);
  return result;
}

} // namespace shape
