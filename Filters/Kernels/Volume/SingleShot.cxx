#include "Volume/OffsetSurface.h"
#include "Volume/Solvers.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace shape
{

int SampleCount(const BoundaryProblem& problem, double ratio)
{
  constexpr double least = 16.0, most = 1e8;
  return static_cast<int>(
    std::clamp(std::round(ratio * problem.Boundary().Points.rows()), least, most));
}

Eigen::MatrixXd PlaceSources(const BoundaryProblem& problem, const Mesh& outer,
  const HarmonicVolumeMapOptions& options, const Progress& progress)
{
  Eigen::MatrixXd sources = SampleSurface(outer, SampleCount(problem, options.SourceRatio),
    options.SourceSampling, options.Seed, progress.Part(0.0, 0.8));
  MoveToDistance(sources, problem.Distance(), options.OffsetDistance, progress.Part(0.8, 1.0));
  return sources;
}

void SolveSingleShot(BoundaryProblem& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress)
{
  const auto start = std::chrono::steady_clock::now();
  const int rows = SampleCount(problem, options.CollocationRatio);
  problem.RequireMemory(rows, SampleCount(problem, options.SourceRatio));
  const Mesh outer = OffsetSurface(
    problem.Distance(), options.OffsetDistance, OffsetSurfaceOptions(), progress.Part(0.0, 0.1));
  const Eigen::MatrixXd sources = PlaceSources(problem, outer, options, progress.Part(0.1, 0.15));
  const BoundaryProblem::Collocations places =
    problem.PlacesOnBoundary(SampleSurface(problem.Boundary(), rows, options.CollocationSampling,
                               options.Seed, progress.Part(0.15, 0.2)),
      Progress());
  const BoundaryProblem::Fit fit = problem.Solve(places, sources, progress.Part(0.2, 0.95));
  const bool kept = problem.Add(
    sources, fit.Charges, static_cast<int>(places.Points.rows()), progress.Part(0.95, 1.0));
  HarmonicVolumeMapResult::Level level = problem.Errors();
  level.Number = 1;
  level.Sources = static_cast<int>(sources.rows());
  level.Collocations = fit.Rows;
  level.Kept = kept;
  level.Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.Levels.push_back(level);
  result.Reason = !kept                     ? HarmonicVolumeMapResult::Stop::NoImprovement
    : level.RMSEInside <= options.Tolerance ? HarmonicVolumeMapResult::Stop::Tolerance
                                            : HarmonicVolumeMapResult::Stop::Levels;
}

} // namespace shape
