#include "Correspondence/AutomaticLandmarks.h"

#include "Core/Errors.h"
#include "Correspondence/FeatureAssignment.h"
#include "Correspondence/FeaturedSurface.h"
#include "Correspondence/LandmarkPlaces.h"
#include "Correspondence/MatchingInput.h"
#include "Correspondence/NearestRows.h"

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

/// Of few and of many features, that agree closely or roughly: different ones each time.
std::vector<Landmarks> Candidates(const FeaturedSurface& a, const FeaturedSurface& b,
  const AutomaticLandmarksOptions& options, const Progress& progress)
{
  std::vector<Landmarks> candidates;
  std::set<Landmarks> known;
  double begin = 0.0;
  for (const int most : { options.Features / 2, 3 * options.Features / 4, options.Features })
  {
    const auto own = Eigen::seqN(0, std::min<Eigen::Index>(most, a.Apart.rows()));
    const auto other = Eigen::seqN(0, std::min<Eigen::Index>(most, b.Apart.rows()));
    for (const double tolerance : { 0.15, 0.3 })
    {
      const Progress part = progress.Part(begin, begin + 1.0 / 6.0);
      begin += 1.0 / 6.0;
      for (const FeatureAssignment& assignment :
        AssignFeatures(a.Apart(own, own), b.Apart(other, other), a.Remoteness(own),
          b.Remoteness(other), tolerance, options.Candidates, part))
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

/// How much distances differ in the map of samples, both ways, that pairs of features give; and in
/// the one that turns the surface over.
std::array<double, 2> Distortions(
  const FeaturedSurface& a, const FeaturedSurface& b, const Landmarks& pairs)
{
  std::vector<int> own, other;
  for (const auto& [i, j] : pairs)
  {
    own.push_back(i);
    other.push_back(j);
  }
  const Eigen::MatrixXd placesA = PlacesAmong(a.ToFeatures, a.Turns, own, 1.0);
  std::array<double, 2> distortions = {};
  for (int mirrored = 0; mirrored < 2; ++mirrored)
  {
    const Eigen::MatrixXd placesB =
      PlacesAmong(b.ToFeatures, b.Turns, other, mirrored ? -1.0 : 1.0);
    distortions[mirrored] = 0.5 *
      (MeanDifference(a, b, NearestRows(placesA, placesB)) +
        MeanDifference(b, a, NearestRows(placesB, placesA)));
  }
  return distortions;
}

/// Whether half or more of the features of A that both assign go to different ones of B.
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

} // namespace

AutomaticLandmarksResult AutomaticLandmarks(
  const Mesh& a, const Mesh& b, const AutomaticLandmarksOptions& options, const Progress& progress)
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
  const std::vector<Landmarks> candidates = Candidates(onA, onB, options, progress.Part(0.8, 0.9));
  if (candidates.empty())
  {
    throw InvalidInput("no three features of surface A are as far apart as three of surface B, so "
                       "that no landmarks were found; give some");
  }
  std::vector<double> distortions;
  AutomaticLandmarksResult result{ {}, Infinity, Infinity, Infinity, 0.0 };
  std::size_t best = 0;
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    progress(0.9 + 0.1 * static_cast<double>(c) / static_cast<double>(candidates.size()));
    const auto [kept, mirrored] = Distortions(onA, onB, candidates[c]);
    distortions.push_back(kept);
    best = kept < distortions[best] ? c : best;
    result.MirroredDistortion = std::min(result.MirroredDistortion, mirrored);
  }
  result.Distortion = distortions[best];
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    if (Contradicts(candidates[c], candidates[best]))
    {
      result.RivalDistortion = std::min(result.RivalDistortion, distortions[c]);
    }
  }
  constexpr double rounding = 1e-9;
  result.Confidence =
    std::max(0.0, 1.0 - (result.Distortion + rounding) / (result.RivalDistortion + rounding));
  for (const auto& [i, j] : candidates[best])
  {
    result.Pairs.push_back({ onA.Features[i], onB.Features[j] });
  }
  progress(1.0);
  return result;
}

} // namespace shape
