#include "Correspondence/Landmarks/AutomaticLandmarks.h"

#include "Base/Errors.h"
#include "Correspondence/Landmarks/FeaturedSurface.h"
#include "Correspondence/Landmarks/LandmarkEmbedding.h"
#include "Correspondence/Landmarks/Private/FeatureAssignment.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Search/NearestSurfacePoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
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

/// The distortions of the two maps of samples that pairs of features determine: the one that keeps
/// the orientation, and the one that reverses it. They are means over both directions; for a part,
/// only those of its own map, relative to its length.
/// Assignments have too few distances to be compared by these alone; the map of all samples
/// distinguishes the wrong ones.
std::array<double, 2> Distortions(const Hypothesis& pair, const Landmarks& pairs)
{
  const FeaturedSurface &a = pair.A, &b = pair.B;
  std::vector<int> own, other;
  for (const auto& [i, j] : pairs)
  {
    own.push_back(i);
    other.push_back(j);
  }
  const Eigen::MatrixXd positionsA = EmbedByDistances(a.ToFeatures, a.Turns, own, 1.0);
  std::array<double, 2> distortions = {};
  for (int mirrored = 0; mirrored < 2; ++mirrored)
  {
    const Eigen::MatrixXd positionsB =
      EmbedByDistances(b.ToFeatures, b.Turns, other, mirrored ? -1.0 : 1.0);
    const double there = pair.Part == SurfacePart::WhichType::SurfaceB
      ? 0.0
      : MeanDifference(a, b, FindNearestRows(positionsA, positionsB));
    const double back = pair.Part == SurfacePart::WhichType::SurfaceA
      ? 0.0
      : MeanDifference(b, a, FindNearestRows(positionsB, positionsA));
    const bool isPart = pair.Part != SurfacePart::WhichType::None;
    distortions[mirrored] = (isPart ? 1.0 / pair.Length : 0.5) * (there + back);
  }
  return distortions;
}

/// Whether at least half of the features of A that both assign go to different features of B.
bool Contradicts(const Landmarks& pairs, const Landmarks& others)
{
  int common = 0, different = 0;
  for (const auto& [i, j] : pairs)
  {
    for (const auto& [k, l] : others)
    {
      common += i == k ? 1 : 0;
      different += i == k && j != l ? 1 : 0;
    }
  }
  return common > 0 && 2 * different >= common;
}

/// The best result of a hypothesis; its distortions are infinite if no three features agree.
/// The best candidate has the smallest distortion; its rival is the best one that contradicts it.
AutomaticLandmarksResult Best(
  const Hypothesis& pair, const AutomaticLandmarksOptions& options, const Progress& progress)
{
  const std::vector<Landmarks> candidates = Candidates(pair, options, progress.Part(0.0, 0.5));
  std::vector<double> distortions;
  AutomaticLandmarksResult result;
  result.Distortion = result.MirroredDistortion = result.RivalDistortion = Infinity;
  result.Part = pair.Part;
  std::size_t best = 0;
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    progress(0.5 + 0.5 * static_cast<double>(c) / static_cast<double>(candidates.size()));
    const auto [kept, mirrored] = Distortions(pair, candidates[c]);
    distortions.push_back(kept);
    best = kept < distortions[best] ? c : best;
    result.MirroredDistortion = std::min(result.MirroredDistortion, mirrored);
  }
  if (candidates.empty())
  {
    return result;
  }
  result.Distortion = distortions[best];
  std::size_t rival = best;
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    if (distortions[c] < result.RivalDistortion && Contradicts(candidates[c], candidates[best]))
    {
      result.RivalDistortion = distortions[c];
      rival = c;
    }
  }
  // A mirror-symmetric shape has equal distortions up to noise: see MirrorImage.
  constexpr double clear = 0.85;
  result.MirrorImage = result.MirroredDistortion < clear * result.Distortion;
  // Of equal surfaces both distortions are 0; the ratio is then 1 and the confidence 0.
  constexpr double rounding = 1e-9;
  result.Confidence =
    std::max(0.0, 1.0 - (result.Distortion + rounding) / (result.RivalDistortion + rounding));
  const auto points = [&](const Landmarks& features)
  {
    Landmarks pairs;
    for (const auto& [i, j] : features)
    {
      pairs.push_back({ pair.A.Features[i], pair.B.Features[j] });
    }
    return pairs;
  };
  result.Pairs = points(candidates[best]);
  result.Rival = rival == best ? Landmarks() : points(candidates[rival]);
  return result;
}

/// The best result over several shares of the area that one surface may have of the other one's.
AutomaticLandmarksResult BestPart(const FeaturedSurface& a, const FeaturedSurface& b,
  SurfacePart::WhichType which, const AutomaticLandmarksOptions& options, const Progress& progress)
{
  // Areas of 85 % down to 0.85^10 = 20 %. A neighbouring share differs by 8 % in length, within the
  // tolerance of the assignments.
  constexpr double largest = 0.85, factor = 0.85;
  constexpr int count = 10;
  const bool isA = which == SurfacePart::WhichType::SurfaceA;
  std::vector<AutomaticLandmarksResult> tried;
  std::size_t best = 0;
  for (int k = 0; k < count; ++k)
  {
    const double share = largest * std::pow(factor, k);
    tried.push_back(Best({ isA ? RestrictToPart(a, share) : a, isA ? b : RestrictToPart(b, share),
                           which, std::sqrt(share) },
      options, progress.Part(k / 10.0, (k + 1) / 10.0)));
    best = tried[k].Distortion < tried[best].Distortion ? k : best;
  }
  // The minimum of the parabola through three distortions gives a share between them.
  double position = static_cast<double>(best);
  if (best > 0 && best + 1 < tried.size())
  {
    const double minimum = tried[best].Distortion, before = tried[best - 1].Distortion - minimum,
                 after = tried[best + 1].Distortion - minimum;
    position += std::isfinite(before + after) && before + after > 0.0
      ? 0.5 * (before - after) / (before + after)
      : 0.0;
  }
  tried[best].Share = largest * std::pow(factor, position);
  return tried[best];
}

} // namespace

// 1. Find features on both surfaces, and samples described relative to them (FindFeatures).
// 2. For each hypothesis (both complete, A a part of B, B a part of A), find assignments of
//    features that agree on the distances between them (Candidates).
// 3. Let each assignment map the samples, and take the one that changes their distances least
//    (Best).
// 4. Accept a part only if it explains the distances clearly better than two complete surfaces.
AutomaticLandmarksResult FindLandmarks(const Surface& a, const Surface& b,
  const AutomaticLandmarksOptions& options, const Progress& progress)
{
  RequireOption(options.Samples >= 20, "Samples", options.Samples, "at least 20");
  RequireOption(options.Features >= 6, "Features", options.Features, "at least 6");
  RequireOption(options.Candidates >= 1, "Candidates", options.Candidates, "at least 1");
  RequireConnected(a, "surface A");
  RequireConnected(b, "surface B");
  const FeaturedSurface onA = FindFeatures(
                          a, options.Samples, options.Features, progress.Part(0.0, 0.4)),
                        onB = FindFeatures(
                          b, options.Samples, options.Features, progress.Part(0.4, 0.8));
  using Which = SurfacePart::WhichType;
  AutomaticLandmarksResult result, part;
  result.Distortion = part.Distortion = Infinity;
  if (options.BothWhole)
  {
    result = Best({ onA, onB, Which::None, 1.0 }, options, progress.Part(0.8, 0.9));
  }
  const bool isOpenA = onA.DistanceToBoundary.allFinite(),
             isOpenB = onB.DistanceToBoundary.allFinite();
  if (options.PartA && (isOpenA || !options.BothWhole))
  {
    part = BestPart(onA, onB, Which::SurfaceA, options, progress.Part(0.9, 0.95));
  }
  if (options.PartB && (isOpenB || !options.BothWhole))
  {
    AutomaticLandmarksResult other =
      BestPart(onA, onB, Which::SurfaceB, options, progress.Part(0.95, 1.0));
    part = other.Distortion < part.Distortion ? other : part;
  }
  // A part has one parameter more, its share, and only one direction is measured, so it always fits
  // a little better.
  constexpr double better = 0.7; // factor for accepting a part
  result = part.Distortion < better * result.Distortion ? part : result;
  if (result.Pairs.empty())
  {
    throw InvalidInput(
      "no landmarks were found: no three features of surface A are as far apart as "
      "three features of surface B; give Landmarks");
  }
  progress(1.0);
  return result;
}

} // namespace shape
