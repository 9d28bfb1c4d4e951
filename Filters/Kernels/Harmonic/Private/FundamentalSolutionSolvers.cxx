#include "Harmonic/Private/FundamentalSolutionSolvers.h"
#include "Harmonic/Private/ChargeShells.h"
#include "Harmonic/Private/OffsetSurface.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace shape
{

namespace
{

/// Number of collocation points for each source at the first level. With fewer the first map
/// oscillates between them, and later maps correct this slowly.
constexpr int CoarseRowsPerSource = 2;
/// Number of new sources at each level / number of sources of a subset.
constexpr double InsertedShare = 0.1;

/// Returns `ratio` times the number of boundary points, rounded, at least 16.
int ComputeSampleCount(const Surface& boundary, double ratio)
{
  // The upper bound keeps the count in the range of int.
  constexpr double minimum = 16.0, maximum = 1e8;
  return static_cast<int>(
    std::clamp(std::round(ratio * boundary.Points().rows()), minimum, maximum));
}

/// Concatenates the rows of all matrices.
Eigen::MatrixXd Concatenate(const std::vector<Eigen::MatrixXd>& parts)
{
  Eigen::Index rows = 0;
  for (const Eigen::MatrixXd& part : parts)
  {
    rows += part.rows();
  }
  Eigen::MatrixXd all(rows, 3);
  rows = 0;
  for (const Eigen::MatrixXd& part : parts)
  {
    all.middleRows(rows, part.rows()) = part;
    rows += part.rows();
  }
  return all;
}

/// Samples the collocation points by CollocationRatio, but at least 48 on each component.
Eigen::MatrixXd SampleBoundary(const FundamentalSolutionFit& problem,
  const HarmonicVolumeMapOptions& options, const Progress& progress)
{
  // Twice the minimum number of sources of a shell (ChargeShells::Fewest).
  constexpr int minimum = 48;
  return Concatenate(SampleSurfaces(SplitComponents(problem.Boundary()),
    ComputeSampleCount(problem.Boundary(), options.CollocationRatio), minimum,
    options.CollocationSampling, options.Seed, progress));
}

/// Divides the sources into evenly spread subsets: subset s takes every `subsets`-th source along a
/// space-filling curve. If a small void's shell has too few sources to divide, every subset gets
/// all of them.
std::vector<Eigen::MatrixXd> DivideIntoSubsets(
  const std::vector<Eigen::MatrixXd>& shells, int subsets)
{
  // Even partitioning of the sources: Li et al. 2010, section 4.1.2.
  std::vector<std::vector<Eigen::MatrixXd>> subsetParts(subsets);
  Eigen::Index largest = 0;
  for (const Eigen::MatrixXd& sources : shells)
  {
    largest = std::max(largest, sources.rows());
  }
  for (const Eigen::MatrixXd& sources : shells)
  {
    const bool divided =
      sources.rows() == largest || sources.rows() >= subsets * ChargeShells::Fewest;
    const Eigen::VectorXi order = FindSpatialOrder(sources);
    for (int s = 0; s < subsets; ++s)
    {
      std::vector<int> chosen;
      for (Eigen::Index i = divided ? s : 0; i < order.size(); i += divided ? subsets : 1)
      {
        chosen.push_back(order(i));
      }
      subsetParts[s].push_back(sources(chosen, Eigen::all));
    }
  }
  std::vector<Eigen::MatrixXd> joined;
  for (const std::vector<Eigen::MatrixXd>& parts : subsetParts)
  {
    joined.push_back(Concatenate(parts));
  }
  return joined;
}

/// Moves sources to `factor` times their distance from the boundary. A source that would come near
/// another part of the boundary is not moved.
void MoveAway(
  Eigen::MatrixXd& sources, const SignedDistance& field, double factor, const Progress& progress)
{
  const Eigen::VectorXd wanted =
    factor * field.Evaluate(sources, progress.Part(0.0, 0.2)).Distances;
  Eigen::MatrixXd moved = sources;
  MoveToDistance(moved, field, wanted, progress.Part(0.2, 0.8));
  const Eigen::VectorXd reached = field.Evaluate(moved, progress.Part(0.8, 1.0)).Distances;
  constexpr double slack = 0.1; // relative to the distance
  const Eigen::Array<bool, Eigen::Dynamic, 1> there =
    (reached - wanted).array().abs() <= slack * wanted.array();
  sources = there.replicate(1, 3).select(moved, sources);
}

/// Reorders `points`: a coarse sample of them comes first.
Eigen::MatrixXd CoarseFirst(const Eigen::MatrixXd& points, int coarse, double area)
{
  if (coarse >= points.rows())
  {
    return points;
  }
  const Eigen::VectorXi chosen = EliminateSamples(
    points, Eigen::VectorXd::Constant(points.rows(), ComputePackingRadius(area, coarse)), coarse);
  std::vector<int> order(chosen.begin(), chosen.end());
  for (int i = 0; i < points.rows(); ++i)
  {
    if (!std::binary_search(chosen.begin(), chosen.end(), i))
    {
      order.push_back(i);
    }
  }
  return points(order, Eigen::all);
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

int ComputeSubsetCount(const Surface& boundary, const HarmonicVolumeMapOptions& options)
{
  constexpr int fewest = 16; // minimum number of sources of a subset
  return std::clamp(options.SourceSubsets, 1,
    std::max(1, ComputeSampleCount(boundary, options.SourceRatio) / fewest));
}

double ComputeCoarseness(int subsets)
{
  return std::sqrt(static_cast<double>(subsets));
}

void AddLevel(const FundamentalSolutionFit& problem, Eigen::Index sources, Eigen::Index rows,
  double gain, std::chrono::steady_clock::time_point& start, HarmonicVolumeMapResult& result)
{
  HarmonicVolumeMapResult::Level level = problem.Errors();
  level.Number = static_cast<int>(result.Levels.size());
  level.Sources = static_cast<int>(sources);
  level.Collocations = static_cast<int>(rows);
  level.Kept = gain > 0.0;
  const auto now = std::chrono::steady_clock::now();
  level.Seconds = std::chrono::duration<double>(now - start).count();
  start = now;
  result.Levels.push_back(level);
}

void SolveSingleShot(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress)
{
  auto start = std::chrono::steady_clock::now();
  // Li et al. 2010, section 3.2: one map, from all sources and collocation points.
  const int rows = ComputeSampleCount(problem.Boundary(), options.CollocationRatio);
  const int sourceCount = ComputeSampleCount(problem.Boundary(), options.SourceRatio);
  problem.RequireMemory(rows, sourceCount);
  const ChargeShells shells(
    problem.Boundary(), options.OffsetDistance, progress.Part(0.0, 0.1, "placing the charges"));
  result.OffsetDistance = shells.Nearest();
  const Eigen::MatrixXd sources = Concatenate(
    shells.Sample(sourceCount, options.SourceSampling, options.Seed, progress.Part(0.1, 0.15)));
  problem.Collocate(SampleBoundary(problem, options, progress.Part(0.15, 0.2)), Progress());
  const FundamentalSolutionFit::Fit fit =
    problem.Solve(problem.Collocations(), sources, progress.Part(0.2, 0.95));
  const double gain = problem.Add(sources, fit.Charges, progress.Part(0.95, 1.0)).Gain;
  AddLevel(problem, sources.rows(), fit.Rows, gain, start, result);
  const bool kept = gain > 0.0;
  result.Reason = !kept ? HarmonicVolumeMapResult::Stop::NoImprovement
    : result.Levels.back().RMSEInside <= options.Tolerance
    ? HarmonicVolumeMapResult::Stop::Tolerance
    : HarmonicVolumeMapResult::Stop::Levels;
}

void SolveMultiLevel(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress)
{
  auto start = std::chrono::steady_clock::now();
  // Outline (Li et al. 2010):
  // 1. Sources are sampled on the shells and divided into subsets (section 4.1.2). The coarse
  //    subsets are moved away from the boundary.
  // 2. Collocation points are sampled on the boundary (section 4.1.1), a coarse sample first.
  // 3. Each level fits the residual with one subset (section 3.3) and adds the map to the sum.
  // 4. Redundant sources of the subset are deleted (section 4.2).
  // 5. Sources are inserted near the worst points, which become collocation points (section 4.1.2).
  const int rows = ComputeSampleCount(problem.Boundary(), options.CollocationRatio);
  const int sourceCount = ComputeSampleCount(problem.Boundary(), options.SourceRatio);
  const int subsets = ComputeSubsetCount(problem.Boundary(), options);
  problem.RequireMemory(rows, (sourceCount + subsets - 1) / subsets);
  const ChargeShells shells(
    problem.Boundary(), options.OffsetDistance, progress.Part(0.0, 0.1, "placing the charges"));
  result.OffsetDistance = shells.Nearest();
  // Step 1: sources.
  std::vector<Eigen::MatrixXd> sources = DivideIntoSubsets(
    shells.Sample(sourceCount, options.SourceSampling, options.Seed, progress.Part(0.1, 0.15)),
    subsets);
  for (int s = 0; s + 1 < subsets; ++s)
  {
    const double finer = static_cast<double>(s) / (subsets - 1);
    MoveAway(sources[s], *problem.Distance(), std::pow(ComputeCoarseness(subsets), 1.0 - finer),
      progress.Part(0.15 + 0.05 * s / subsets, 0.15 + 0.05 * (s + 1) / subsets));
  }
  // Step 2. With several components the counts are rounded, so there may be one point less than
  // requested.
  const Eigen::MatrixXd positions = SampleBoundary(problem, options, progress.Part(0.2, 0.25));
  const int coarseRows =
    static_cast<int>(std::min(positions.rows(), CoarseRowsPerSource * sources.front().rows()));
  problem.Collocate(
    CoarseFirst(positions, coarseRows, ComputePointAreas(problem.Boundary()).sum()), Progress());

  const SurfaceLocator outer(shells.Joined());
  const double spacing = std::sqrt(shells.Area() / sourceCount);
  int idle = 0; // number of levels in a row that gained too little
  for (int number = 1; number <= options.MaximumLevels; ++number)
  {
    const double share = 0.75 / options.MaximumLevels;
    const Progress part = progress.Part(0.25 + (number - 1) * share, 0.25 + number * share);
    // Step 3. The first level fits the coarse sample alone: the low-resolution map of the paper.
    Eigen::MatrixXd& subset = sources[(number - 1) % subsets];
    const FundamentalSolutionFit::Fit fit =
      problem.Solve(number == 1 ? coarseRows : problem.Collocations(), subset, part.Part(0.0, 0.8));
    const double gain = problem.Add(subset, fit.Charges, part.Part(0.8, 1.0)).Gain;

    AddLevel(problem, subset.rows(), fit.Rows, gain, start, result);
    const HarmonicVolumeMapResult::Level& level = result.Levels.back();
    if (level.RMSEInside <= options.Tolerance)
    {
      result.Reason = HarmonicVolumeMapResult::Stop::Tolerance;
      return;
    }
    idle = gain < options.LeastGain ? idle + 1 : 0;
    // Consecutive levels use different subsets. So the sum may still gain after one level without
    // gain, unless there is only one subset.
    if (idle == std::min(2, subsets))
    {
      result.Reason = HarmonicVolumeMapResult::Stop::NoImprovement;
      return;
    }

    // Step 4. A subset without sources could not be fitted again, so at least one is kept.
    if (static_cast<Eigen::Index>(fit.Redundant.size()) < subset.rows())
    {
      subset = WithoutRows(subset, fit.Redundant);
      result.DeletedSources += static_cast<int>(fit.Redundant.size());
    }
    // Step 5. If the map was left out, the residual is unchanged and its worst points already have
    // sources.
    if (level.Kept)
    {
      const int inserted = static_cast<int>(InsertedShare * sourceCount / subsets);
      const Eigen::MatrixXd worst = problem.WorstPoints(inserted, spacing);
      // The worst points are projected onto the shells and become sources of the next level's
      // subset.
      AppendRows(sources[number % subsets], outer.Find(worst).Positions);
      problem.Collocate(worst, Progress());
      result.InsertedSources += static_cast<int>(worst.rows());
    }
  }
  result.Reason = HarmonicVolumeMapResult::Stop::Levels;
}

} // namespace shape
