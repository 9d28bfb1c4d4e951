#include "Geodesics/ExactGeodesics.h"

#include "Base/Parallel.h"
#include "Geodesics/Private/WindowPropagation.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <vector>

namespace shape
{
namespace
{

/// Windows and points between two progress calls: a few milliseconds.
constexpr int StepsBetween = 4096;
/// Progress is reported between slices, so that an abort takes effect within a tenth of a second.
constexpr std::chrono::milliseconds Slice(100);

/// Computes one pair after the other; it can be interrupted within a pair.
struct Worker
{
  WindowPropagation Paths;
  int Pair = -1;
};

} // namespace

Eigen::VectorXd ComputeExactGeodesics(
  const Surface& surface, const ClosestPoints& seeds, const Progress& progress)
{
  const HalfEdgeFrames frames(surface);
  WindowPropagation propagation(surface, frames);
  for (Eigen::Index i = 0; i < seeds.Triangles.size(); ++i)
  {
    propagation.AddSeed(seeds.Triangles(i), seeds.Barycentrics.row(i));
  }
  // Mitchell, Mount and Papadimitriou: continuous Dijkstra on windows (WindowPropagation).
  while (!propagation.Run(StepsBetween))
  {
    progress(propagation.Done());
  }
  progress(1.0);
  return propagation.Distances();
}

Eigen::VectorXd ComputeExactGeodesicsBetween(const Surface& surface, const SurfacePoints& from,
  const SurfacePoints& to, const Progress& progress)
{
  const int count = static_cast<int>(from.Triangles.size());
  const HalfEdgeFrames frames(surface);
  const Eigen::MatrixXi& triangles = surface.Triangles();
  const Eigen::VectorXi& component = surface.Topology().ComponentId;
  Eigen::VectorXd distances(count);
  // Each worker has its own propagation, which is as large as the surface and is used for one pair
  // after the other.
  std::vector<Worker> workers(
    std::clamp(GetThreadCount(), 1, std::max(count, 1)), { { surface, frames }, -1 });
  std::atomic<int> taken{ 0 }, done{ 0 };
  // A pair's distance does not depend on its worker, nor on when it is interrupted.
  const auto work = [&](Worker& worker)
  {
    const auto until = std::chrono::steady_clock::now() + Slice;
    while (std::chrono::steady_clock::now() < until)
    {
      if (worker.Pair < 0)
      {
        const int pair = taken++;
        if (pair >= count)
        {
          return;
        }
        if (component(triangles(from.Triangles(pair), 0)) !=
          component(triangles(to.Triangles(pair), 0)))
        {
          // not connected; no search needed
          distances(pair) = std::numeric_limits<double>::infinity();
          ++done;
          continue;
        }
        worker.Pair = pair;
        worker.Paths.SetGoal(to.Triangles(pair), to.Barycentrics.row(pair));
        worker.Paths.AddSeed(from.Triangles(pair), from.Barycentrics.row(pair));
      }
      if (worker.Paths.Run(StepsBetween))
      {
        distances(worker.Pair) = worker.Paths.GoalDistance();
        worker.Paths.Clear();
        worker.Pair = -1;
        ++done;
      }
    }
  };
  while (done < count)
  {
    ParallelFor(static_cast<int>(workers.size()), 1,
      [&](int begin, int end)
      { std::for_each(&workers[begin], &workers[begin] + (end - begin), work); });
    progress(static_cast<double>(done) / count);
  }
  progress(1.0);
  return distances;
}

} // namespace shape
