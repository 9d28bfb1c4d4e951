#include "Correspondence/Private/LandmarkSearch.h"

#include "Base/Errors.h"
#include "Correspondence/Conformal/MoebiusVoting.h"

#include <cmath>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Options = CorrespondenceOptions;

/// The first pairs that prefer each other; the votes become a coupling of the samples.
LandmarkSearch FindByVotes(
  const Surface& a, const Surface& b, const Options& options, const Progress& progress)
{
  if (options.Part == Options::PartType::SurfaceA || options.Part == Options::PartType::SurfaceB)
  {
    throw InvalidInput("MoebiusVotes finds landmarks of complete surfaces, but Part is " +
      std::string(options.Part == Options::PartType::SurfaceA ? "SurfaceA" : "SurfaceB") +
      "; set FindLandmarksBy to Distances");
  }
  MoebiusVotes votes = VoteByMoebiusMaps(a, b, options.Voting, progress);
  // Tips come first, then the farthest points, so the first pairs are spread over the surfaces.
  // Tips get few votes, because conformal maps draw extremities together, but they guide a map
  // best.
  constexpr std::size_t maximum = 12;
  if (votes.Pairs.size() > maximum)
  {
    votes.Pairs.resize(maximum);
  }
  LandmarkSearch result;
  result.VotingMaps = votes.Maps;
  result.VotingConfidence =
    votes.Confidences.head(static_cast<Eigen::Index>(votes.Pairs.size())).mean();
  result.Pairs = std::move(votes.Pairs);
  result.Votes = { std::move(votes.SamplesOfA), std::move(votes.SamplesOfB),
    votes.Votes.rowwise().sum(), votes.Votes.colwise().sum(), votes.Votes };
  result.Part.Scale = std::sqrt(ComputePointAreas(b).sum() / ComputePointAreas(a).sum());
  return result;
}

} // namespace

LandmarkSearch SearchLandmarks(const Surface& a, const Surface& b, const Landmarks& landmarks,
  bool find, const Options& given, const Progress& progress)
{
  using Part = Options::PartType;
  using Which = SurfacePart::WhichType;
  // Generalised scaling treats both surfaces as complete, and has no landmarks to find a part by.
  const bool isScaling = given.Method == Options::MethodType::GeneralizedMDS;
  const Part part = landmarks.empty() && isScaling ? Part::None : given.Part;
  const bool isA = part == Part::SurfaceA, isB = part == Part::SurfaceB;
  LandmarkSearch result;
  if (!find)
  {
    result.Pairs = landmarks;
    result.Part = isA || isB
      ? MeasurePart(a, b, landmarks, isA ? Which::SurfaceA : Which::SurfaceB, progress)
      : FindPart(a, b, part == Part::None ? Landmarks() : landmarks, progress);
    return result;
  }
  if (given.FindLandmarksBy == Options::FinderType::MoebiusVotes)
  {
    return FindByVotes(a, b, given, progress);
  }
  AutomaticLandmarksOptions options;
  options.Rank = given.Rank;
  options.BothWhole = !isA && !isB;
  options.PartA = isA || part == Part::Automatic;
  options.PartB = isB || part == Part::Automatic;
  result.Start = FindLandmarks(a, b, options, progress);
  result.Pairs = result.Start.Pairs;
  const double share = result.Start.Share,
               ratio = ComputePointAreas(b).sum() / ComputePointAreas(a).sum();
  result.Part = { result.Start.Part,
    std::sqrt(result.Start.Part == Which::SurfaceB ? ratio / share : ratio * share), share };
  return result;
}

} // namespace shape
