#include "Harmonic/Private/FundamentalSolutionSolvers.h"
#include "Harmonic/Private/SourceShells.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace shape
{

int ComputeSampleCount(const Mesh& boundary, double ratio)
{
  constexpr double minimum = 16.0, maximum = 1e8;
  return static_cast<int>(std::clamp(std::round(ratio * boundary.Points.rows()), minimum, maximum));
}

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

Eigen::MatrixXd SampleBoundary(const FundamentalSolutionFit& problem,
  const HarmonicVolumeMapOptions& options, const Progress& progress)
{
  constexpr int minimum = 48;
  return Concatenate(SampleSurfaces(SplitComponents(problem.Boundary()),
    ComputeSampleCount(problem.Boundary(), options.CollocationRatio), minimum,
    options.CollocationSampling, options.Seed, progress));
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
  const SourceShells shells(problem.Boundary(), options.OffsetDistance, progress.Part(0.0, 0.1));
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

} // namespace shape
