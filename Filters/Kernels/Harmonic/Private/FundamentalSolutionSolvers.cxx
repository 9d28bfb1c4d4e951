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

/// The first level's collocation points for each of its sources: fewer let the first map swing
/// between them, which later ones are slow to mend.
constexpr int CoarseRowsPerSource = 2;
/// New sources of a level, as a share of a subset.
constexpr double InsertedShare = 0.1;

/// How many points a ratio of the boundary's asks for, at least 16.
int ComputeSampleCount(const Surface& boundary, double ratio)
{
  constexpr double minimum = 16.0, maximum = 1e8;
  return static_cast<int>(
    std::clamp(std::round(ratio * boundary.Points().rows()), minimum, maximum));
}

/// The rows of all matrices.
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

/// So many collocation points, and more if a component would have less than 48.
Eigen::MatrixXd SampleBoundary(const FundamentalSolutionFit& problem,
  const HarmonicVolumeMapOptions& options, const Progress& progress)
{
  constexpr int minimum = 48;
  return Concatenate(SampleSurfaces(SplitComponents(problem.Boundary()),
    ComputeSampleCount(problem.Boundary(), options.CollocationRatio), minimum,
    options.CollocationSampling, options.Seed, progress));
}

/// The sources in subsets, each spread evenly: every so many-th source along a curve that keeps
/// neighbours together. The shell of a small void has too few to be divided: every subset gets all
/// of them.
std::vector<Eigen::MatrixXd> DivideIntoSubsets(
  const std::vector<Eigen::MatrixXd>& shells, int subsets)
{
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

/// Moves sources to `factor` times their distance from the boundary. Those that meet another part
/// of it on the way stay where they are.
void MoveAway(
  Eigen::MatrixXd& sources, const SignedDistance& field, double factor, const Progress& progress)
{
  const Eigen::VectorXd wanted =
    factor * field.Evaluate(sources, progress.Part(0.0, 0.2)).Distances;
  Eigen::MatrixXd moved = sources;
  MoveToDistance(moved, field, wanted, progress.Part(0.2, 0.8));
  const Eigen::VectorXd reached = field.Evaluate(moved, progress.Part(0.8, 1.0)).Distances;
  constexpr double slack = 0.1; // of the distance
  const Eigen::Array<bool, Eigen::Dynamic, 1> there =
    (reached - wanted).array().abs() <= slack * wanted.array();
  sources = there.replicate(1, 3).select(moved, sources);
}

/// `points` with a coarse sample of them first.
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
  constexpr int fewest = 16; // sources of a subset
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
  const int rows = ComputeSampleCount(problem.Boundary(), options.CollocationRatio);
  const int sourceCount = ComputeSampleCount(problem.Boundary(), options.SourceRatio);
  problem.RequireMemory(rows, sourceCount);
  const ChargeShells shells(problem.Boundary(), options.OffsetDistance, progress.Part(0.0, 0.1));
  result.OffsetDistance = shells.Nearest();
  const Eigen::MatrixXd sources = Concatenate(
    shells.Sample(sourceCount, options.SourceSampling, options.Seed, progress.Part(0.1, 0.15)));
  problem.Collocate(SampleBoundary(problem, options, progress.Part(0.15, 0.2)), Progress());
  const FundamentalSolutionFit::Fit fit =
    problem.Solve(problem.Collocations(), sources, progress.Part(0.2, 0.95));
  const double gain = problem.Add(sources, fit.Charges, progress.Part(0.95, 1.0));
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
  const int rows = ComputeSampleCount(problem.Boundary(), options.CollocationRatio);
  const int sourceCount = ComputeSampleCount(problem.Boundary(), options.SourceRatio);
  const int subsets = ComputeSubsetCount(problem.Boundary(), options);
  problem.RequireMemory(rows, (sourceCount + subsets - 1) / subsets);
  const ChargeShells shells(problem.Boundary(), options.OffsetDistance, progress.Part(0.0, 0.1));
  result.OffsetDistance = shells.Nearest();
  std::vector<Eigen::MatrixXd> sources = DivideIntoSubsets(
    shells.Sample(sourceCount, options.SourceSampling, options.Seed, progress.Part(0.1, 0.15)),
    subsets);
  for (int s = 0; s + 1 < subsets; ++s)
  {
    const double finer = static_cast<double>(s) / (subsets - 1);
    MoveAway(sources[s], problem.Distance(), std::pow(ComputeCoarseness(subsets), 1.0 - finer),
      progress.Part(0.15 + 0.05 * s / subsets, 0.15 + 0.05 * (s + 1) / subsets));
  }
  // With several components their shares are rounded: there may be a point less than asked for.
  const Eigen::MatrixXd positions = SampleBoundary(problem, options, progress.Part(0.2, 0.25));
  const int coarseRows =
    static_cast<int>(std::min(positions.rows(), CoarseRowsPerSource * sources.front().rows()));
  problem.Collocate(
    CoarseFirst(positions, coarseRows, ComputePointAreas(problem.Boundary()).sum()), Progress());

  const SurfaceLocator outer(shells.Joined());
  const double spacing = std::sqrt(shells.Area() / sourceCount);
  int idle = 0; // levels in a row that gained too little
  for (int number = 1; number <= options.MaximumLevels; ++number)
  {
    const double share = 0.75 / options.MaximumLevels;
    const Progress part = progress.Part(0.25 + (number - 1) * share, 0.25 + number * share);
    Eigen::MatrixXd& subset = sources[(number - 1) % subsets];
    const FundamentalSolutionFit::Fit fit =
      problem.Solve(number == 1 ? coarseRows : problem.Collocations(), subset, part.Part(0.0, 0.8));
    const double gain = problem.Add(subset, fit.Charges, part.Part(0.8, 1.0));

    AddLevel(problem, subset.rows(), fit.Rows, gain, start, result);
    const HarmonicVolumeMapResult::Level& level = result.Levels.back();
    if (level.RMSEInside <= options.Tolerance)
    {
      result.Reason = HarmonicVolumeMapResult::Stop::Tolerance;
      return;
    }
    idle = gain < options.LeastGain ? idle + 1 : 0;
    if (idle == std::min(2, subsets))
    {
      result.Reason = HarmonicVolumeMapResult::Stop::NoImprovement;
      return;
    }

    // A subset never runs empty: without a source it could not be fitted again.
    if (static_cast<Eigen::Index>(fit.Redundant.size()) < subset.rows())
    {
      subset = WithoutRows(subset, fit.Redundant);
      result.DeletedSources += static_cast<int>(fit.Redundant.size());
    }
    // After a map that was left out the worst points are those that were treated already.
    if (level.Kept)
    {
      const int inserted = static_cast<int>(InsertedShare * sourceCount / subsets);
      const Eigen::MatrixXd worst = problem.WorstPoints(inserted, spacing);
      AppendRows(sources[number % subsets], outer.Find(worst).Positions);
      problem.Collocate(worst, Progress());
      result.InsertedSources += static_cast<int>(worst.rows());
    }
  }
  result.Reason = HarmonicVolumeMapResult::Stop::Levels;
}

} // namespace shape
