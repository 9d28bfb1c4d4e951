#include "Correspondence/Conformal/Private/ConformalCandidates.h"

#include "Base/Parallel.h"
#include "Correspondence/Conformal/Private/SampleTriples.h"
#include "Correspondence/Landmarks/DistanceQuantiles.h"
#include "Correspondence/Landmarks/FeaturedSurface.h"
#include "Correspondence/Landmarks/GeodesicSamples.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Geodesics/FarthestPoints.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shape
{
namespace
{

/// All triples of `count` landmarks, or evenly spread ones if there are too many.
std::vector<std::vector<int>> Triples(int count)
{
  // 25 landmarks already have 2300 triples, and each map is evaluated at all samples.
  constexpr std::size_t maximum = 300;
  std::vector<std::vector<int>> all, some;
  for (int i = 0; i < count; ++i)
  {
    for (int j = i + 1; j < count; ++j)
    {
      for (int k = j + 1; k < count; ++k)
      {
        all.push_back({ i, j, k });
      }
    }
  }
  // A constant stride through the lexicographic order reaches all landmarks.
  const std::size_t stride = std::max<std::size_t>(1, (all.size() + maximum - 1) / maximum);
  for (std::size_t t = 0; t < all.size(); t += stride)
  {
    some.push_back(all[t]);
  }
  return some;
}

/// The landmarks, the tips of extremities away from them, and the farthest points.
GeodesicSamples FeatureSamples(
  const Surface& surface, std::vector<int> first, int count, const Progress& progress)
{
  constexpr int distances = 200, features = 12;
  for (const int feature :
    FindFeatures(surface, distances, features, progress.Part(0.0, 0.6)).Features)
  {
    if (std::find(first.begin(), first.end(), feature) == first.end())
    {
      first.push_back(feature);
    }
  }
  return SampleSurface(surface, count, progress.Part(0.6, 1.0), first, FindRemotestPoint(surface));
}

/// The mean squared difference of the quantiles of each sample of A and each of B.
Eigen::MatrixXd LevelDifferences(
  const Surface& a, const GeodesicSamples& onA, const Surface& b, const GeodesicSamples& onB)
{
  constexpr int levels = 10;
  const Eigen::MatrixXd ofA = ComputeDistanceQuantiles(onA.Distances, ComputePointAreas(a), levels),
                        ofB = ComputeDistanceQuantiles(onB.Distances, ComputePointAreas(b), levels);
  Eigen::MatrixXd differences(ofA.rows(), ofB.rows());
  for (Eigen::Index i = 0; i < ofA.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < ofB.rows(); ++j)
    {
      differences(i, j) = (ofA.row(i) - ofB.row(j)).squaredNorm() / levels;
    }
  }
  return differences;
}

/// The triples whose points have the most similar distances from each other and from all points.
std::vector<TriplePair> MostSimilar(const std::vector<TriplePair>& all, const Surface& a,
  const GeodesicSamples& onA, const Surface& b, const GeodesicSamples& onB, int count)
{
  const Eigen::MatrixXd levels = LevelDifferences(a, onA, b, onB), betweenA = onA.Between(),
                        betweenB = onB.Between();
  std::vector<double> costs;
  for (const TriplePair& pair : all)
  {
    double cost = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const double difference =
        betweenA(pair.OfA[k], pair.OfA[next]) - betweenB(pair.OfB[k], pair.OfB[next]);
      cost += levels(pair.OfA[k], pair.OfB[k]) + difference * difference;
    }
    costs.push_back(cost);
  }
  std::vector<int> order(all.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return costs[i] < costs[j]; });
  order.resize(std::min<std::size_t>(order.size(), count));
  std::vector<TriplePair> similar;
  for (const int t : order)
  {
    similar.push_back(all[t]);
  }
  return similar;
}

/// See ConformalCandidate::Fit. wanted: the partners of the landmarks.
double FitOf(const Eigen::MatrixXd& positions, const Eigen::VectorXd& trust,
  const Eigen::MatrixXd& wanted, double agreement)
{
  constexpr double tiny =
    1e-300; // a map that is trusted nowhere fits as if it were equally trusted
  const Eigen::ArrayXd weights = trust.array().max(tiny);
  const Eigen::ArrayXd squares = (positions - wanted).rowwise().squaredNorm().array();
  return std::exp(-(weights * squares).sum() / (weights.sum() * agreement * agreement));
}

} // namespace

std::vector<ConformalCandidate> MapLandmarkTriples(
  const RoundSurface& a, const RoundSurface& b, const Landmarks& landmarks)
{
  const std::vector<int> onA = PointsOf(landmarks, 0), onB = PointsOf(landmarks, 1);
  std::vector<ConformalCandidate> maps;
  for (const std::vector<int>& triple : Triples(static_cast<int>(landmarks.size())))
  {
    ConformalCandidate map;
    for (int k = 0; k < 3; ++k)
    {
      map.OfA(k) = onA[triple[k]];
      map.OfB(k) = onB[triple[k]];
    }
    map.Moebius =
      SolveMoebiusTransform(a.Points(map.OfA, Eigen::all), b.Points(map.OfB, Eigen::all));
    if (map.Moebius.allFinite())
    {
      maps.push_back(map);
    }
  }
  return maps;
}

std::vector<ConformalCandidate> MapFeatureTriples(const Surface& a, const RoundSurface& roundA,
  const Surface& b, const RoundSurface& roundB, const SurfaceLocator& locator,
  const Landmarks& landmarks, const FeatureTripleOptions& options, const Progress& progress)
{
  const auto given = static_cast<int>(landmarks.size());
  const GeodesicSamples onA = FeatureSamples(
                          a, PointsOf(landmarks, 0), options.Points, progress.Part(0.0, 0.3)),
                        onB = FeatureSamples(
                          b, PointsOf(landmarks, 1), options.Points, progress.Part(0.3, 0.6));
  const std::vector<TriplePair> all = FindSimilarTriples(
    onA.Between(), onB.Between(), given + options.Points, options.Tolerance, given);
  const std::vector<TriplePair> triples = MostSimilar(all, a, onA, b, onB, options.Compared);
  std::vector<ConformalCandidate> maps(triples.size());
  constexpr int samples = 32, chunk = 16;
  std::vector<int> compared = SampleFarthestPoints(a, samples, {}, FindRemotestPoint(a));
  const std::vector<int> marks = PointsOf(landmarks, 0);
  compared.insert(compared.end(), marks.begin(), marks.end());
  const Eigen::MatrixXd wanted = roundB.Embedding(PointsOf(landmarks, 1), Eigen::all);
  Eigen::VectorXd trust(static_cast<Eigen::Index>(triples.size()));
  ParallelFor(
    static_cast<int>(triples.size()), chunk,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        ConformalCandidate& map = maps[t];
        for (int k = 0; k < 3; ++k)
        {
          map.OfA(k) = onA.Points[triples[t].OfA[k]];
          map.OfB(k) = onB.Points[triples[t].OfB[k]];
        }
        map.Moebius = SolveMoebiusTransform(
          roundA.Points(map.OfA, Eigen::all), roundB.Points(map.OfB, Eigen::all));
        trust(t) = -1.0;
        if (map.Moebius.allFinite())
        {
          const ConformalImages images =
            ComputeConformalImages(roundA, compared, roundB, locator, map.Moebius);
          map.Fit = given == 0 ? 1.0
                               : FitOf(images.Positions.bottomRows(given), images.Trust.tail(given),
                                   wanted, options.Agreement);
          trust(t) = map.Fit * images.Trust.head(images.Trust.size() - given).mean();
        }
      }
    },
    progress.Part(0.6, 1.0));
  std::vector<int> order(triples.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return trust(i) > trust(j); });
  std::vector<ConformalCandidate> kept;
  for (const int t : order)
  {
    if (trust(t) >= 0.0 && static_cast<int>(kept.size()) < options.Kept)
    {
      kept.push_back(maps[t]);
    }
  }
  return kept;
}

} // namespace shape
