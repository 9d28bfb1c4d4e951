#include "Correspondence/Conformal/BlendedIntrinsic.h"

#include "Base/Errors.h"
#include "Correspondence/Conformal/Private/ConformalCandidates.h"
#include "Correspondence/Conformal/Private/MapGroups.h"
#include "Correspondence/Conformal/Private/RoundSurface.h"
#include "Correspondence/Landmarks/AutomaticLandmarks.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Geodesics/FarthestPoints.h"
#include "Search/ClosestPoint.h"
#include "Search/NearestSurfacePoints.h"

#include <Eigen/LU>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Returns whether the surface has a boundary.
bool RequireGenusZero(const Surface& surface, const std::string& name)
{
  const Topology topology = RequireConnected(surface, name);
  const int genus = ComputeGenus(topology);
  if (genus != 0)
  {
    throw InvalidInput(name + " has genus " + std::to_string(genus) +
      "; maps through the sphere need genus 0: cut each handle with Clip and close the cuts with "
      "Shape Fill Holes, or take another "
      "method");
  }
  return topology.BoundaryLoops > 0;
}

/// The images of all candidates at samples.
std::vector<ConformalImages> ImagesAtSamples(const RoundSurface& a, const RoundSurface& b,
  const SurfaceLocator& locator, const std::vector<ConformalCandidate>& maps,
  const std::vector<int>& samples, const Progress& progress)
{
  std::vector<ConformalImages> images;
  for (const ConformalCandidate& map : maps)
  {
    progress(static_cast<double>(images.size()) / static_cast<double>(maps.size()));
    images.push_back(ComputeConformalImages(a, samples, b, locator, map.Moebius));
  }
  return images;
}

/// As far as landmarks at twice the distance Agreement from their partners: exp(-4).
constexpr double LeastFit = 0.018;

/// See ConformalCandidate::Fit.
Eigen::VectorXd LandmarkFit(const std::vector<ConformalCandidate>& maps)
{
  Eigen::VectorXd fit(static_cast<Eigen::Index>(maps.size()));
  std::transform(
    maps.begin(), maps.end(), fit.begin(), [](const ConformalCandidate& map) { return map.Fit; });
  return fit;
}

/// The maps with the largest weights.
std::vector<int> SelectLargest(const Eigen::VectorXd& weights, int count)
{
  std::vector<int> order(weights.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int i, int j) { return weights(i) > weights(j); });
  order.resize(std::min<std::size_t>(order.size(), count));
  return order;
}

/// Conformal maps with their weights.
struct Blend
{
  std::vector<Eigen::Matrix2cd> Maps;
  Eigen::VectorXd Weights;
};

/// Third step of the paper, section 5: the positions nearest to the mean images of all points, and
/// the confidence there. Only the trust varies from point to point.
SurfacePoints Blended(const RoundSurface& from, const RoundSurface& to, const Surface& target,
  const SurfaceLocator& locator, const Blend& blend, double agreement, Eigen::VectorXd& confidence,
  const Progress& progress)
{
  std::vector<int> points(from.Areas.size());
  std::iota(points.begin(), points.end(), 0);
  ImageBlend sums(from.Areas.size(), to.Embedding.cols());
  for (std::size_t k = 0; k < blend.Maps.size(); ++k)
  {
    progress(0.7 * static_cast<double>(k) / static_cast<double>(blend.Maps.size()));
    // One map at a time: storing the images under all maps would need memory for 60 embeddings.
    sums.Add(ComputeConformalImages(from, points, to, locator, blend.Maps[k]),
      blend.Weights(static_cast<Eigen::Index>(k)));
  }
  confidence = sums.Confidences(agreement);
  // The mean of images is not on the embedded surface in general; it is projected there.
  return FindNearestSurfacePoints(sums.Means(), target.Triangles(),
    to.Embedding.topRows(to.Areas.size()), progress.Part(0.7, 1.0));
}

/// What the candidates are, for the user.
void ListCandidates(const std::vector<ConformalCandidate>& maps, BlendedIntrinsicResult& result)
{
  const auto count = static_cast<Eigen::Index>(maps.size());
  result.TriplesOfA.resize(count, 3);
  result.TriplesOfB.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    result.TriplesOfA.row(i) = maps[i].OfA;
    result.TriplesOfB.row(i) = maps[i].OfB;
  }
}

} // namespace

// Kim, Lipman and Funkhouser's algorithm:
// 1. Map both surfaces conformally to the sphere (MakeRound).
// 2. For triples of landmarks, or of feature points, compute the Moebius transform between the
//    spheres (ConformalCandidates).
// 3. Weight the maps by their agreement with each other, and keep the best (MapGroups).
// 4. Average the images of each point, weighted by map and by local trust (Blended).
// 5. Repeat the blend from B to A with the inverse Moebius transforms.
BlendedIntrinsicResult ComputeBlendedIntrinsicMap(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const BlendedIntrinsicOptions& options, const Progress& progress)
{
  RequireOption(options.Candidates >= 1, "Candidates", options.Candidates, "at least 1");
  RequireOption(options.Samples >= 10, "Samples", options.Samples, "at least 10");
  RequireOption(options.Agreement > 0.0, "Agreement", options.Agreement, "positive");
  RequireOption(options.TripletPoints >= 3, "TripletPoints", options.TripletPoints, "at least 3");
  RequireOption(
    options.TripletTolerance > 0.0, "TripletTolerance", options.TripletTolerance, "positive");
  RequireOption(options.TripletMaps >= 1, "TripletMaps", options.TripletMaps, "at least 1");
  RequireOption(options.GroupShare > 0.0 && options.GroupShare <= 1.0, "GroupShare",
    options.GroupShare, "above 0, at most 1");
  const bool isTriplets =
    options.CandidatesFrom == BlendedIntrinsicOptions::CandidatesType::Triplets;
  const bool isOpenA = RequireGenusZero(a, "surface A"), isOpenB = RequireGenusZero(b, "surface B");
  RequireLandmarks(landmarks, a, b);
  if (!isTriplets && !landmarks.empty() && landmarks.size() < 3)
  {
    throw InvalidInput("there are " + std::to_string(landmarks.size()) +
      " landmarks, but a map needs three; give three or more, or none to have them found");
  }
  const Landmarks used = landmarks.empty() && !isTriplets
    ? FindLandmarks(a, b, {}, progress.Part(0.0, 0.2, "finding landmarks")).Pairs
    : landmarks;
  // Both surfaces use one method, or their maps would not agree. The more conformal method can fail
  // on one of them by rounding alone if a fan is close to the surface that it closes, as on a
  // sheet.
  const SphereMapMethod first =
    isOpenA || isOpenB ? SphereMapMethod::PositiveFlow : SphereMapMethod::ConformalFlow;
  RoundSurface onA = MakeRoundSurface(
                 a, first, progress.Part(0.2, 0.4, "mapping SurfaceA to the sphere")),
               onB = MakeRoundSurface(
                 b, first, progress.Part(0.4, 0.6, "mapping SurfaceB to the sphere"));
  if (onA.Method < onB.Method)
  {
    onA = MakeRoundSurface(a, onB.Method, progress.Part(0.6, 0.7));
  }
  else if (onB.Method < onA.Method)
  {
    onB = MakeRoundSurface(b, onA.Method, progress.Part(0.6, 0.7));
  }
  const SurfaceLocator locatorA(onA.Sphere), locatorB(onB.Sphere);
  std::vector<ConformalCandidate> maps;
  if (isTriplets)
  {
    FeatureTripleOptions own;
    own.Points = options.TripletPoints;
    own.Tolerance = options.TripletTolerance;
    own.Kept = options.TripletMaps;
    own.Agreement = options.Agreement;
    maps = MapFeatureTriples(
      a, onA, b, onB, locatorB, used, own, progress.Part(0.7, 0.75, "finding conformal maps"));
  }
  else
  {
    maps = MapLandmarkTriples(onA, onB, used);
  }
  if (maps.empty())
  {
    throw InvalidInput(isTriplets
        ? "no three feature points of surface A have distances like three of surface B; raise "
          "TripletTolerance or TripletPoints, or set CandidatesFrom to Landmarks"
        : "of the " + std::to_string(used.size()) +
          " landmarks, no three are distinct points on both surfaces; give three that are apart");
  }
  const std::vector<ConformalImages> images = ImagesAtSamples(onA, onB, locatorB, maps,
    SampleFarthestPoints(a, options.Samples, {}, isTriplets ? FindRemotestPoint(a) : -1),
    progress.Part(0.75, 0.8, "choosing conformal maps"));
  BlendedIntrinsicResult result;
  ListCandidates(maps, result);
  const Eigen::VectorXd fit = LandmarkFit(maps);
  if (fit.maxCoeff() < LeastFit)
  {
    throw InvalidInput("none of the " + std::to_string(maps.size()) +
      " conformal maps takes the landmarks near their partners; check the landmarks, raise "
      "Agreement, or set CandidatesFrom to Landmarks");
  }
  result.Consistency =
    fit.asDiagonal() * ComputeConsistency(images, options.Agreement) * fit.asDiagonal();
  result.Weights = isTriplets
    ? FindBestGroup(images, result.Consistency, options.Agreement, options.GroupShare)
    : FindLeadingWeights(result.Consistency);
  Blend blend;
  const std::vector<int> selected = isTriplets
    ? SelectForEachRegion(images, result.Weights, options.Candidates)
    : SelectLargest(result.Weights, options.Candidates);
  for (const int k : selected)
  {
    blend.Maps.push_back(maps[k].Moebius);
  }
  blend.Weights = result.Weights(selected);
  result.Maps.AToB = Blended(onA, onB, b, locatorB, blend, options.Agreement, result.ConfidenceOfA,
    progress.Part(0.8, 0.9, "blending the maps"));
  for (Eigen::Matrix2cd& moebius : blend.Maps)
  {
    // The same maps with the same weights serve both directions, so the two results are consistent.
    moebius = moebius.inverse().eval();
  }
  result.Maps.BToA = Blended(onB, onA, a, locatorA, blend, options.Agreement, result.ConfidenceOfB,
    progress.Part(0.9, 1.0, "blending the maps"));
  return result;
}

} // namespace shape
