#include "Correspondence/Landmarks/AutomaticLandmarks.h"

#include "Base/Errors.h"
#include "Correspondence/Landmarks/FeaturedSurface.h"
#include "Correspondence/Landmarks/LandmarkCandidates.h"
#include "Correspondence/Landmarks/LandmarkEmbedding.h"
#include "Correspondence/Landmarks/Private/FeatureAssignment.h"
#include "Correspondence/Landmarks/Private/RefinedCandidate.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Search/NearestSurfacePoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Both surfaces under the hypothesis that one of them is a part of the other one, or that none is.
struct Hypothesis
{
  FeaturedSurface A, B;
  SurfacePart::WhichType Part;
  double Length; ///< the root of the part's area, relative to that of the other surface
};

/// Distinct assignments of few and of many features, with a close and a rough agreement.
std::vector<Landmarks> Candidates(
  const Hypothesis& pair, const AutomaticLandmarksOptions& options, const Progress& progress)
{
  std::vector<Landmarks> candidates;
  std::set<Landmarks> known;
  double begin = 0.0;
  // The mean distance from all of a part is not comparable to that from all of the other surface.
  const bool isPart = pair.Part != SurfacePart::WhichType::None;
  const Eigen::VectorXd levelsA =
    isPart ? Eigen::VectorXd::Ones(pair.A.Remoteness.size()) : pair.A.Remoteness;
  const Eigen::VectorXd levelsB =
    isPart ? Eigen::VectorXd::Ones(pair.B.Remoteness.size()) : pair.B.Remoteness;
  // Few features give assignments without spurious tips, many give assignments that also fix the
  // minor extremities. Which are right is unknown, so all are compared by their maps.
  for (const int maximum : { options.Features / 2, 3 * options.Features / 4, options.Features })
  {
    const auto own = Eigen::seqN(0, std::min<Eigen::Index>(maximum, pair.A.Apart.rows()));
    const auto other = Eigen::seqN(0, std::min<Eigen::Index>(maximum, pair.B.Apart.rows()));
    for (const double tolerance : { 0.15, 0.3 })
    {
      const Progress part = progress.Part(begin, begin + 1.0 / 6.0);
      begin += 1.0 / 6.0;
      for (const FeatureAssignment& assignment :
        AssignFeatures(pair.A.Apart(own, own), pair.B.Apart(other, other), levelsA(own),
          levelsB(other), tolerance, options.Candidates, part))
      {
        if (known.insert(assignment.Pairs).second)
        {
          candidates.push_back(assignment.Pairs);
        }
      }
    }
  }
  return candidates;
}

double MeanDifference(
  const FeaturedSurface& a, const FeaturedSurface& b, const Eigen::VectorXi& images)
{
  const Eigen::MatrixXd differences = (a.Between - b.Between(images, images)).cwiseAbs();
  return a.Weights.dot(differences * a.Weights);
}

/// A map of the samples, which pairs of features determine.
struct Candidate
{
  Landmarks Pairs;            ///< of features
  Eigen::VectorXi AToB, BToA; ///< for each sample, its image: a sample of the other surface
  double Distortion = Infinity;
  double Error = Infinity;  ///< by which candidates are ordered
  FunctionalMaps Maps = {}; ///< of complete surfaces: the refined map
};

/// The maps under a hypothesis, the best first; none if no three features agree.
struct Found
{
  SurfacePart::WhichType Part = SurfacePart::WhichType::None;
  double Share = 1.0;
  ///@{
  /// The points of the features; a part has fewer than its surface.
  std::vector<int> FeaturesOfA, FeaturesOfB;
  ///@}
  std::vector<Candidate> Maps;
  double MirroredDistortion = Infinity;

  double Distortion() const
  {
    return this->Maps.empty() ? Infinity : this->Maps.front().Distortion;
  }
};

/// The map of samples that pairs of features determine: the one that keeps the orientation, or the
/// one that reverses it. Its distortion is the mean over both directions; for a part, that of its
/// own map only, relative to its length.
/// Assignments have too few distances to be compared by these alone; the map of all samples
/// distinguishes the wrong ones.
Candidate MapSamples(const Hypothesis& pair, const Landmarks& pairs, bool mirrored)
{
  const FeaturedSurface &a = pair.A, &b = pair.B;
  std::vector<int> own, other;
  for (const auto& [i, j] : pairs)
  {
    own.push_back(i);
    other.push_back(j);
  }
  const Eigen::MatrixXd positionsA = EmbedByDistances(a.ToFeatures, a.Turns, own, 1.0),
                        positionsB =
                          EmbedByDistances(b.ToFeatures, b.Turns, other, mirrored ? -1.0 : 1.0);
  Candidate map{ pairs, FindNearestRows(positionsA, positionsB),
    FindNearestRows(positionsB, positionsA) };
  const double there =
    pair.Part == SurfacePart::WhichType::SurfaceB ? 0.0 : MeanDifference(a, b, map.AToB);
  const double back =
    pair.Part == SurfacePart::WhichType::SurfaceA ? 0.0 : MeanDifference(b, a, map.BToA);
  const bool isPart = pair.Part != SurfacePart::WhichType::None;
  map.Distortion = map.Error = (isPart ? 1.0 / pair.Length : 0.5) * (there + back);
  return map;
}

/// The first `count` of the maps whose samples have images elsewhere than those of all before them:
/// by more than a 20th of the root of the area, on average.
std::vector<Candidate> Distinct(
  const Hypothesis& pair, const std::vector<Candidate>& maps, std::size_t count)
{
  constexpr double least = 0.05; // maps that refine to the same one are nearer
  const bool fromB = pair.Part == SurfacePart::WhichType::SurfaceB;
  const FeaturedSurface &from = fromB ? pair.B : pair.A, &to = fromB ? pair.A : pair.B;
  const auto isNear = [&](const Candidate& one, const Candidate& other)
  {
    const Eigen::VectorXi &images = fromB ? one.BToA : one.AToB,
                          &others = fromB ? other.BToA : other.AToB;
    double mean = 0.0;
    for (Eigen::Index i = 0; i < images.size(); ++i)
    {
      mean += from.Weights(i) * to.Between(images(i), others(i));
    }
    return mean <= least;
  };
  std::vector<Candidate> distinct;
  for (const Candidate& map : maps)
  {
    if (distinct.size() < count &&
      std::none_of(distinct.begin(), distinct.end(),
        [&](const Candidate& other) { return isNear(map, other); }))
    {
      distinct.push_back(map);
    }
  }
  return distinct;
}

void Sort(std::vector<Candidate>& maps)
{
  std::stable_sort(maps.begin(), maps.end(),
    [](const Candidate& one, const Candidate& other) { return one.Error < other.Error; });
}

/// How many maps are refined, and offered at most. (Of 62 pairs, the right one was the first or
/// second one before it was refined; twice as many select the same.)
constexpr std::size_t Offered = 8;

Found FindMaps(
  const Hypothesis& pair, const AutomaticLandmarksOptions& options, const Progress& progress)
{
  const std::vector<Landmarks> candidates = Candidates(pair, options, progress.Part(0.0, 0.5));
  Found found;
  found.Part = pair.Part;
  found.FeaturesOfA = pair.A.Features;
  found.FeaturesOfB = pair.B.Features;
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    progress(0.5 + 0.5 * static_cast<double>(c) / static_cast<double>(candidates.size()));
    found.Maps.push_back(MapSamples(pair, candidates[c], false));
    found.MirroredDistortion =
      std::min(found.MirroredDistortion, MapSamples(pair, candidates[c], true).Distortion);
  }
  Sort(found.Maps);
  found.Maps = Distinct(pair, found.Maps, Offered);
  return found;
}

/// The maps over several shares of the area that one surface may have of the other one's.
Found FindMapsOfPart(const FeaturedSurface& a, const FeaturedSurface& b,
  SurfacePart::WhichType which, const AutomaticLandmarksOptions& options, const Progress& progress)
{
  // Areas of 85 % down to 0.85^10 = 20 %. A neighbouring share differs by 8 % in length, within the
  // tolerance of the assignments.
  constexpr double largest = 0.85, factor = 0.85;
  constexpr int count = 10;
  const bool isA = which == SurfacePart::WhichType::SurfaceA;
  std::vector<Found> tried;
  std::size_t best = 0;
  for (int k = 0; k < count; ++k)
  {
    const double share = largest * std::pow(factor, k);
    tried.push_back(FindMaps({ isA ? RestrictToPart(a, share) : a,
                               isA ? b : RestrictToPart(b, share), which, std::sqrt(share) },
      options, progress.Part(k / 10.0, (k + 1) / 10.0)));
    best = tried[k].Distortion() < tried[best].Distortion() ? k : best;
  }
  // The minimum of the parabola through three distortions gives a share between them.
  double position = static_cast<double>(best);
  if (best > 0 && best + 1 < tried.size())
  {
    const double minimum = tried[best].Distortion(),
                 before = tried[best - 1].Distortion() - minimum,
                 after = tried[best + 1].Distortion() - minimum;
    position += std::isfinite(before + after) && before + after > 0.0
      ? 0.5 * (before - after) / (before + after)
      : 0.0;
  }
  tried[best].Share = largest * std::pow(factor, position);
  return tried[best];
}

/// The pairs of features that a refined map takes near each other; all if these are less than
/// three.
Landmarks Agreeing(const Landmarks& pairs, const RefinedCandidate& map, const FeaturedSurface& b)
{
  constexpr double near = 0.2; // over the root of the area: twice the distance of samples and more
  Landmarks agreeing;
  for (const auto& [i, j] : pairs)
  {
    if (b.ToFeatures(map.FeaturesToB(i), j) < near)
    {
      agreeing.push_back({ i, j });
    }
  }
  constexpr std::size_t fewest = 3;
  return agreeing.size() < fewest ? pairs : agreeing;
}

/// The geometric mean of the errors of a map. The reversed area has two thirds of the weight of
/// each other one. (Of 100 pairs of poses, it then selects the right map of all. Without it, one
/// map exchanges left and right. With full weight, one of 7 stretched shapes does.)
double MeanError(double distortion, const RefinedCandidate& refined)
{
  constexpr double noise = 0.01; // right maps of remeshed surfaces reverse some area, too
  constexpr double weight = 2.0 / 3.0;
  return std::pow(distortion * refined.Commutativity * refined.Orthonormality *
      std::pow(refined.ReversedArea + noise, weight),
    1.0 / (3.0 + weight));
}

/// Refines the maps of complete surfaces, and orders them by their errors.
void Refine(const MatchedSurface& a, const MatchedSurface& b, std::vector<Candidate>& maps,
  const Progress& progress)
{
  const CandidateRefinement refinement(a, b);
  for (std::size_t k = 0; k < maps.size(); ++k)
  {
    const auto done = [&](std::size_t count)
    { return static_cast<double>(count) / static_cast<double>(maps.size()); };
    RefinedCandidate refined =
      refinement.Refine(maps[k].AToB, maps[k].BToA, progress.Part(done(k), done(k + 1)));
    maps[k].Pairs = Agreeing(maps[k].Pairs, refined, b.Featured);
    maps[k].AToB = std::move(refined.AToB);
    maps[k].Maps = std::move(refined.Maps);
    maps[k].Error = MeanError(maps[k].Distortion, refined);
  }
  Sort(maps);
  maps = Distinct({ a.Featured, b.Featured, SurfacePart::WhichType::None, 1.0 }, maps, maps.size());
}

/// Adds the map of two surfaces that stand alike: the nearest samples in space. Nearly round shapes
/// have no tips whose distances tell them apart. It is added if three features agree.
void AddMapAsTheyStand(
  const MatchedSurface& a, const MatchedSurface& b, std::vector<Candidate>& maps)
{
  const auto positions = [](const MatchedSurface& side, const std::vector<int>& points)
  {
    const Eigen::VectorXd areas = ComputePointAreas(side.Surface);
    const Eigen::RowVector3d centre = areas.transpose() * side.Surface.Points() / areas.sum();
    return Eigen::MatrixXd(
      (side.Surface.Points()(points, Eigen::all).rowwise() - centre) / std::sqrt(areas.sum()));
  };
  const Eigen::MatrixXd featuresA = positions(a, a.Featured.Features),
                        featuresB = positions(b, b.Featured.Features),
                        samplesA = positions(a, a.Featured.Samples),
                        samplesB = positions(b, b.Featured.Samples);
  Candidate map{ {}, FindNearestRows(samplesA, samplesB), FindNearestRows(samplesB, samplesA) };
  const Eigen::VectorXi there = FindNearestRows(featuresA, featuresB),
                        back = FindNearestRows(featuresB, featuresA);
  for (int i = 0; i < static_cast<int>(there.size()); ++i)
  {
    if (back(there(i)) == i)
    {
      map.Pairs.push_back({ i, there(i) });
    }
  }
  map.Distortion = 0.5 *
    (MeanDifference(a.Featured, b.Featured, map.AToB) +
      MeanDifference(b.Featured, a.Featured, map.BToA));
  constexpr std::size_t fewest = 3;
  if (map.Pairs.size() >= fewest)
  {
    maps.push_back(std::move(map));
  }
}

/// The points of pairs of features.
Landmarks PointsOfFeatures(
  const Landmarks& features, const std::vector<int>& ofA, const std::vector<int>& ofB)
{
  Landmarks pairs;
  for (const auto& [i, j] : features)
  {
    pairs.push_back({ ofA[i], ofB[j] });
  }
  return pairs;
}

LaplaceEigenpairs SolveScaled(const Surface& surface, int pairs, const Progress& progress)
{
  const double length = std::sqrt(ComputePointAreas(surface).sum());
  constexpr double tolerance = 1e-6; // as precise as the comparison needs
  return SolveLaplaceEigenproblem({ surface.Points() / length, surface.Triangles() },
    static_cast<int>(std::min<Eigen::Index>(pairs, surface.Points().rows())), progress, tolerance);
}

void RequireLandmarkOptions(const AutomaticLandmarksOptions& options)
{
  RequireOption(options.Samples >= 20, "Samples", options.Samples, "at least 20");
  RequireOption(options.Features >= 6, "Features", options.Features, "at least 6");
  RequireOption(options.Candidates >= 1, "Candidates", options.Candidates, "at least 1");
  RequireOption(options.Rank >= 0, "Rank", options.Rank, "at least 0");
}

/// The result: the map of the wanted rank, and the best one of the others. smallest: the smallest
/// distortion of any map.
AutomaticLandmarksResult Describe(const Found& found, double smallest, int rank)
{
  const auto wanted = static_cast<std::size_t>(rank);
  if (wanted >= found.Maps.size())
  {
    throw InvalidInput("Rank is " + std::to_string(rank) + ", but only " +
      std::to_string(found.Maps.size()) + " different maps were found; set Rank to at most " +
      std::to_string(found.Maps.size() - 1));
  }
  const auto points = [&](const Landmarks& features)
  { return PointsOfFeatures(features, found.FeaturesOfA, found.FeaturesOfB); };
  const Candidate& map = found.Maps[wanted];
  AutomaticLandmarksResult result;
  result.Part = found.Part;
  result.Share = found.Share;
  result.Alternatives = static_cast<int>(found.Maps.size());
  result.Pairs = points(map.Pairs);
  result.Distortion = map.Distortion;
  result.Error = map.Error;
  result.MirroredDistortion = found.MirroredDistortion;
  // A mirror-symmetric shape has equal distortions up to noise: see MirrorImage.
  constexpr double clear = 0.85;
  result.MirrorImage = result.MirroredDistortion < clear * smallest;
  result.RivalDistortion = result.RivalError = Infinity;
  if (found.Maps.size() > 1)
  {
    const Candidate& rival = found.Maps[wanted == 0 ? 1 : 0];
    result.Rival = points(rival.Pairs);
    result.RivalDistortion = rival.Distortion;
    result.RivalError = rival.Error;
  }
  // The errors of equal surfaces are 0; of two symmetric maps, the ratio is then 1 and the
  // confidence 0.
  constexpr double rounding = 1e-5; // of the eigenpairs, magnified by the root
  result.Confidence =
    std::max(0.0, 1.0 - (result.Error + rounding) / (result.RivalError + rounding));
  constexpr double certain = 0.1;
  result.Certain = result.Confidence >= certain;
  return result;
}

} // namespace

// 1. Find features on both surfaces, and samples described relative to them (FindFeatures).
// 2. For each hypothesis (both complete, A a part of B, B a part of A), find assignments of
//    features that agree on the distances between them (Candidates).
// 3. Let each assignment map the samples, and keep the different maps that change their distances
//    least (FindMaps).
// 4. Accept a part only if it explains the distances clearly better than two complete surfaces.
// 5. Add the map of surfaces that stand alike (AddMapAsTheyStand).
// 6. Refine the maps of complete surfaces, and order them by what is left of their errors (Refine).
AutomaticLandmarksResult FindLandmarks(const Surface& a, const Surface& b,
  const AutomaticLandmarksOptions& options, const Progress& progress)
{
  RequireLandmarkOptions(options);
  RequireConnected(a, "surface A");
  RequireConnected(b, "surface B");
  const FeaturedSurface onA = FindFeatures(
                          a, options.Samples, options.Features, progress.Part(0.0, 0.2)),
                        onB = FindFeatures(
                          b, options.Samples, options.Features, progress.Part(0.2, 0.4));
  using Which = SurfacePart::WhichType;
  const Hypothesis whole{ onA, onB, Which::None, 1.0 };
  Found found, part;
  if (options.BothWhole)
  {
    found = FindMaps(whole, options, progress.Part(0.4, 0.5));
  }
  const bool isOpenA = onA.DistanceToBoundary.allFinite(),
             isOpenB = onB.DistanceToBoundary.allFinite();
  if (options.PartA && (isOpenA || !options.BothWhole))
  {
    part = FindMapsOfPart(onA, onB, Which::SurfaceA, options, progress.Part(0.5, 0.55));
  }
  if (options.PartB && (isOpenB || !options.BothWhole))
  {
    Found other = FindMapsOfPart(onA, onB, Which::SurfaceB, options, progress.Part(0.55, 0.6));
    if (other.Distortion() < part.Distortion())
    {
      part = std::move(other);
    }
  }
  // A part has one parameter more, its share, and only one direction is measured, so it always fits
  // a little better.
  constexpr double better = 0.7; // factor for accepting a part
  if (part.Distortion() < better * found.Distortion())
  {
    found = std::move(part);
  }
  if (found.Maps.empty())
  {
    throw InvalidInput(
      "no landmarks were found: no three features of surface A are as far apart as "
      "three features of surface B; give Landmarks");
  }
  const double smallest = found.Distortion();
  if (found.Part == Which::None)
  {
    const int pairs = static_cast<int>(std::min<Eigen::Index>(
      { CandidateRefinement::Functions, a.Points().rows(), b.Points().rows() }));
    const MatchedSurface one{ a, onA, SolveScaled(a, pairs, progress.Part(0.6, 0.68)) };
    const MatchedSurface two{ b, onB, SolveScaled(b, pairs, progress.Part(0.68, 0.76)) };
    AddMapAsTheyStand(one, two, found.Maps);
    Refine(one, two, found.Maps, progress.Part(0.76, 1.0));
  }
  const AutomaticLandmarksResult result = Describe(found, smallest, options.Rank);
  progress(1.0);
  return result;
}

MatchedSurface PrepareMatching(const Surface& surface, int pairs,
  const AutomaticLandmarksOptions& options, const Progress& progress)
{
  RequireLandmarkOptions(options);
  RequireConnected(surface, "the surface");
  return { surface,
    FindFeatures(surface, options.Samples, options.Features, progress.Part(0.0, 0.5)),
    SolveScaled(surface, pairs, progress.Part(0.5, 1.0)) };
}

std::vector<LandmarkCandidate> FindLandmarkCandidates(const MatchedSurface& a,
  const MatchedSurface& b, const AutomaticLandmarksOptions& options, const Progress& progress)
{
  Found found = FindMaps({ a.Featured, b.Featured, SurfacePart::WhichType::None, 1.0 }, options,
    progress.Part(0.0, 0.4));
  AddMapAsTheyStand(a, b, found.Maps);
  Refine(a, b, found.Maps, progress.Part(0.4, 1.0));
  std::vector<LandmarkCandidate> candidates;
  for (Candidate& map : found.Maps)
  {
    candidates.push_back({ PointsOfFeatures(map.Pairs, a.Featured.Features, b.Featured.Features),
      map.Distortion, map.Error, std::move(map.Maps) });
  }
  return candidates;
}

} // namespace shape
