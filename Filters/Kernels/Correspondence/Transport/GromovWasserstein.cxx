#include "Correspondence/Transport/GromovWasserstein.h"

#include "Base/Errors.h"
#include "Correspondence/Landmarks/AutomaticLandmarks.h"
#include "Correspondence/Landmarks/GeodesicSamples.h"
#include "Correspondence/Landmarks/LandmarkEmbedding.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Search/NearestSurfacePoints.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Returns the landmarks without those that share a point with an earlier one.
Landmarks Distinct(const Landmarks& landmarks)
{
  Landmarks distinct;
  for (const auto& pair : landmarks)
  {
    if (std::none_of(distinct.begin(), distinct.end(),
          [&](const auto& other) { return other[0] == pair[0] || other[1] == pair[1]; }))
    {
      distinct.push_back(pair);
    }
  }
  return distinct;
}

/// Returns the longest distance of both.
double Longest(const GeodesicSamples& a, const GeodesicSamples& b)
{
  return std::max(a.Between().maxCoeff(), b.Between().maxCoeff());
}

/// The costs of pairs of samples (PairFeatures).
Eigen::MatrixXd FeatureCosts(
  const PairFeatures& features, const std::vector<int>& onA, const std::vector<int>& onB)
{
  const Eigen::Index columns = features.OfA.cols();
  Eigen::MatrixXd costs =
    Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(columns > 0 ? onA.size() : 0),
      static_cast<Eigen::Index>(columns > 0 ? onB.size() : 0));
  for (Eigen::Index k = 0; k < columns; ++k)
  {
    const double range = std::max(features.OfA.col(k).maxCoeff(), features.OfB.col(k).maxCoeff()) -
      std::min(features.OfA.col(k).minCoeff(), features.OfB.col(k).minCoeff());
    if (range > 0.0)
    {
      const Eigen::VectorXd a = features.OfA(onA, k) / range, b = features.OfB(onB, k) / range;
      costs += (a.rowwise().replicate(b.size()) - b.transpose().colwise().replicate(a.size()))
                 .cwiseAbs2() /
        static_cast<double>(columns);
    }
  }
  return costs;
}

void CheckFeatures(const PairFeatures& features, const Surface& a, const Surface& b)
{
  if (features.OfA.cols() != features.OfB.cols())
  {
    throw InvalidInput("the features have " + std::to_string(features.OfA.cols()) +
      " components on surface A and " + std::to_string(features.OfB.cols()) +
      " on surface B; give both the same");
  }
  if (features.OfA.cols() > 0 &&
    (features.OfA.rows() != a.Points().rows() || features.OfB.rows() != b.Points().rows() ||
      !features.OfA.allFinite() || !features.OfB.allFinite()))
  {
    throw InvalidInput("features must be finite and have a row for each point");
  }
}

/// The first `fixed` samples of both are fixed pairs.
MetricSpaces Spaces(
  const GeodesicSamples& a, const GeodesicSamples& b, int fixed, const PairFeatures& features)
{
  MetricSpaces spaces{ a.Between(), b.Between(), a.Weights, b.Weights,
    FeatureCosts(features, a.Points, b.Points), features.FeatureWeight };
  Normalize(spaces, fixed);
  return spaces;
}

/// The logarithm of the similarity of rows, at most 0.
Eigen::MatrixXd Likeness(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  constexpr double deviation = 0.05; // of the root of the area
  Eigen::MatrixXd squares = -2.0 * a * b.transpose();
  squares.colwise() += a.rowwise().squaredNorm();
  squares.rowwise() += b.rowwise().squaredNorm().transpose();
  return -0.5 / (deviation * deviation) * squares;
}

/// The image of each point of `from`, given the masses from its samples to those of `to`.
/// The soft functional map of section 4 of the paper: least squares weighted by the mass of each
/// sample.
SurfacePoints Spread(const LaplaceEigenpairs& from, const std::vector<int>& samples,
  const Surface& target, const LaplaceEigenpairs& to, const std::vector<int>& targetSamples,
  const Eigen::MatrixXd& masses, const Progress& progress)
{
  const Eigen::VectorXd weights = masses.rowwise().sum(), roots = weights.cwiseSqrt();
  const Eigen::MatrixXd images =
    weights.cwiseInverse().asDiagonal() * masses * to.Eigenfunctions(targetSamples, Eigen::all);
  const Eigen::MatrixXd map = (roots.asDiagonal() * from.Eigenfunctions(samples, Eigen::all))
                                .eval()
                                .colPivHouseholderQr()
                                .solve(roots.asDiagonal() * images);
  return FindNearestSurfacePoints(
    from.Eigenfunctions * map, target.Triangles(), to.Eigenfunctions, progress);
}

/// The starts of the couplings.
std::vector<Landmarks> Starts(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const GromovWassersteinOptions& options, const Progress& progress)
{
  if (!landmarks.empty())
  {
    return { landmarks };
  }
  if (!options.Starts.empty())
  {
    return options.Starts;
  }
  const AutomaticLandmarksResult found = FindLandmarks(a, b, {}, progress);
  return found.Rival.empty() ? std::vector<Landmarks>{ found.Pairs }
                             : std::vector<Landmarks>{ found.Pairs, found.Rival };
}

} // namespace

GromovWassersteinResult ComputeGromovWassersteinMap(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const GromovWassersteinOptions& options, const Progress& progress)
{
  RequireOption(options.Samples >= 10, "Samples", options.Samples, "at least 10");
  RequireOption(options.Eigenpairs >= 2, "Eigenpairs", options.Eigenpairs, "at least 2");
  RequireConnected(a, "surface A");
  RequireConnected(b, "surface B");
  RequireLandmarks(landmarks, a, b);
  CheckFeatures(options.Features, a, b);
  const Landmarks distinct = Distinct(landmarks);
  const std::vector<Landmarks> starts =
    Starts(a, b, distinct, options, progress.Part(0.0, 0.1, "finding landmarks"));
  const auto fixed = static_cast<int>(distinct.size());
  Landmarks pinned;
  for (int k = 0; k < fixed; ++k)
  {
    pinned.push_back({ k, k });
  }
  const GeodesicSamples onA = SampleSurface(a, options.Samples,
                          progress.Part(0.1, 0.13, "computing geodesic distances"),
                          PointsOf(distinct, 0)),
                        onB = SampleSurface(b, options.Samples,
                          progress.Part(0.13, 0.16, "computing geodesic distances"),
                          PointsOf(distinct, 1));
  const bool isFullA = fixed == static_cast<int>(onA.Points.size()),
             isFullB = fixed == static_cast<int>(onB.Points.size());
  if (isFullA != isFullB)
  {
    throw InvalidInput(std::string("all ") + std::to_string(fixed) + " points of surface " +
      (isFullA ? "A" : "B") + " are landmarks, so the other points of surface " +
      (isFullA ? "B" : "A") + " have no partner; give fewer landmarks, or subdivide surface " +
      (isFullA ? "A" : "B"));
  }
  // Distance matrices have few^2 entries and products few^3: a quarter costs a 64th.
  const int few = fixed + std::max(options.Samples / 4, 10);
  const GeodesicSamples fewA = GetFirstSamples(onA, few, ComputePointAreas(a)),
                        fewB = GetFirstSamples(onB, few, ComputePointAreas(b));
  GromovWassersteinResult result;
  MetricSpaces spaces = Spaces(fewA, fewB, fixed, options.Features);
  EntropicCoupling coupling;
  double least = std::numeric_limits<double>::infinity();
  // Coupling on a quarter of the samples, once for each start. The problem is not convex; the
  // distortion shows which local minimum is better.
  for (std::size_t k = 0; k < starts.size(); ++k)
  {
    const double share = 0.1 / static_cast<double>(starts.size()),
                 begin = 0.16 + share * static_cast<double>(k);
    const Eigen::MatrixXd positionsA = EmbedByLandmarks(a, PointsOf(starts[k], 0)),
                          positionsB = EmbedByLandmarks(b, PointsOf(starts[k], 1));
    EntropicCoupling own = SolveCoupling(spaces,
      Likeness(positionsA(fewA.Points, Eigen::all), positionsB(fewB.Points, Eigen::all)), pinned,
      options.Coupling, progress.Part(begin, begin + share, "coupling the samples"));
    const double ofCosts = spaces.Costs.size() > 0 ? spaces.CostWeight : 0.0;
    const double cost = (1.0 - ofCosts) * own.Distortion * own.Distortion + ofCosts * own.Cost;
    if (cost < least)
    {
      least = cost;
      coupling = std::move(own);
      result.Start = starts[k];
    }
  }
  if (onA.Points.size() > fewA.Points.size() || onB.Points.size() > fewB.Points.size())
  {
    spaces = Spaces(onA, onB, fixed, options.Features);
    // Iterations for each entropy: the coupling starts near its minimum.
    constexpr int fewer = 3;
    EntropicCouplingOptions last = options.Coupling;
    last.IterationsPerEntropy = std::min(last.IterationsPerEntropy, fewer);
    coupling = RefineCoupling(
      spaces, coupling.Masses, pinned, last, progress.Part(0.26, 0.9, "coupling the samples"));
  }
  result.Distortion = coupling.Distortion * Longest(onA, onB);
  result.FeatureCost = coupling.Cost;
  result.Error = coupling.Error;
  const LaplaceEigenpairs spectrumA = SolveLaplaceEigenproblem(a,
                            std::min<int>(options.Eigenpairs, onA.Points.size()),
                            progress.Part(0.9, 0.92, "computing the eigenfunctions")),
                          spectrumB = SolveLaplaceEigenproblem(b,
                            std::min<int>(options.Eigenpairs, onB.Points.size()),
                            progress.Part(0.92, 0.94, "computing the eigenfunctions"));
  result.Maps = { Spread(spectrumA, onA.Points, b, spectrumB, onB.Points, coupling.Masses,
                    progress.Part(0.94, 0.97, "finding the nearest points")),
    Spread(spectrumB, onB.Points, a, spectrumA, onA.Points, coupling.Masses.transpose(),
      progress.Part(0.97, 1.0, "finding the nearest points")) };
  result.Coupling = { onA.Points, onB.Points, std::move(spaces.WeightsA),
    std::move(spaces.WeightsB), std::move(coupling.Masses) };
  return result;
}

} // namespace shape
