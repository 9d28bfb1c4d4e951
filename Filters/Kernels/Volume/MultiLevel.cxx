#include "Volume/OffsetSurface.h"
#include "Volume/Solvers.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace shape
{

namespace
{

/// The first level's collocation points for each of its sources: fewer let the first map swing
/// between them, which later ones are slow to mend.
constexpr int CoarseRowsPerSource = 2;
/// New sources of a level, as a share of a subset.
constexpr double InsertedShare = 0.1;

/// The sources dealt out along a curve that keeps neighbours together: each subset is spread
/// evenly.
std::vector<Eigen::MatrixXd> Deal(const Eigen::MatrixXd& sources, int subsets)
{
  const Eigen::VectorXi order = SpatialOrder(sources);
  std::vector<std::vector<int>> hands(subsets);
  for (Eigen::Index i = 0; i < order.size(); ++i)
  {
    hands[i % subsets].push_back(order(i));
  }
  std::vector<Eigen::MatrixXd> dealt;
  for (const std::vector<int>& hand : hands)
  {
    dealt.push_back(sources(hand, Eigen::all));
  }
  return dealt;
}

Eigen::MatrixXd WithoutRows(const Eigen::MatrixXd& matrix, const std::vector<int>& rows)
{
  std::vector<int> kept;
  for (int i = 0; i < matrix.rows(); ++i)
  {
    if (!std::binary_search(rows.begin(), rows.end(), i))
    {
      kept.push_back(i);
    }
  }
  return matrix(kept, Eigen::all);
}

void AppendRows(Eigen::MatrixXd& matrix, const Eigen::MatrixXd& rows)
{
  matrix.conservativeResize(matrix.rows() + rows.rows(), matrix.cols());
  matrix.bottomRows(rows.rows()) = rows;
}

} // namespace

void SolveMultiLevel(BoundaryProblem& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress)
{
  auto start = std::chrono::steady_clock::now();
  const int rows = SampleCount(problem, options.CollocationRatio);
  const int sourceCount = SampleCount(problem, options.SourceRatio);
  constexpr int fewest = 16; // sources of a subset
  const int subsets = std::clamp(options.SourceSubsets, 1, std::max(1, sourceCount / fewest));
  problem.RequireMemory(rows, (sourceCount + subsets - 1) / subsets);
  const Mesh outer = OffsetSurface(
    problem.Distance(), options.OffsetDistance, OffsetSurfaceOptions(), progress.Part(0.0, 0.1));
  const SurfaceLocator outerLocator(outer);
  std::vector<Eigen::MatrixXd> sources =
    Deal(PlaceSources(problem, outer, options, progress.Part(0.1, 0.2)), subsets);
  const double area = 0.5 * AreaVectors(outer).rowwise().norm().sum();
  const double spacing = std::sqrt(area / sourceCount);
  const auto sample = [&](int count, const Progress& part)
  {
    return SampleSurface(
      problem.Boundary(), count, options.CollocationSampling, options.Seed, part);
  };
  const int coarseRows =
    std::min(rows, CoarseRowsPerSource * static_cast<int>(sources.front().rows()));
  Eigen::MatrixXd places = sample(coarseRows, progress.Part(0.2, 0.25));

  int failures = 0;
  for (int number = 1; number <= options.MaximumLevels; ++number)
  {
    const double share = 0.75 / options.MaximumLevels;
    const Progress part = progress.Part(0.25 + (number - 1) * share, 0.25 + number * share);
    Eigen::MatrixXd& subset = sources[(number - 1) % subsets];
    const BoundaryProblem::Collocations collocations =
      problem.PlacesOnBoundary(places, part.Part(0.0, 0.1));
    const BoundaryProblem::Fit fit = problem.Solve(collocations, subset, part.Part(0.1, 0.7));
    const bool kept = problem.Add(
      subset, fit.Charges, static_cast<int>(collocations.Points.rows()), part.Part(0.7, 0.8));

    HarmonicVolumeMapResult::Level level = problem.Errors();
    level.Number = number;
    level.Sources = static_cast<int>(subset.rows());
    level.Collocations = fit.Rows;
    level.Kept = kept;
    const auto now = std::chrono::steady_clock::now();
    level.Seconds = std::chrono::duration<double>(now - start).count();
    start = now;
    result.Levels.push_back(level);
    failures = kept ? 0 : failures + 1;
    if (level.RMSEInside <= options.Tolerance || failures == subsets)
    {
      result.Reason = failures > 0 ? HarmonicVolumeMapResult::Stop::NoImprovement
                                   : HarmonicVolumeMapResult::Stop::Tolerance;
      return;
    }

    // A subset never runs empty: without a source it could not be fitted again.
    if (static_cast<Eigen::Index>(fit.Redundant.size()) < subset.rows())
    {
      subset = WithoutRows(subset, fit.Redundant);
      result.DeletedSources += static_cast<int>(fit.Redundant.size());
    }
    if (number == 1)
    {
      places = sample(rows, part.Part(0.8, 1.0));
    }
    // After a map that was left out the worst points are those that were treated already.
    if (kept)
    {
      const int inserted = static_cast<int>(InsertedShare * sourceCount / subsets);
      const Eigen::MatrixXd worst = problem.WorstPoints(inserted, spacing);
      AppendRows(sources[number % subsets], outerLocator.Find(worst).Positions);
      AppendRows(places, worst);
      result.InsertedSources += static_cast<int>(worst.rows());
    }
  }
  result.Reason = HarmonicVolumeMapResult::Stop::Levels;
}

} // namespace shape
