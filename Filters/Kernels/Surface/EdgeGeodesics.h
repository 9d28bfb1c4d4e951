#pragma once

#include "Core/Mesh.h"
#include "Core/Progress.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Points that distances begin at, and how far each is from where they are counted from.
struct EdgeSeeds
{
  std::vector<int> Points;
  Eigen::VectorXd Distances;
};

/// The length of the shortest path along edges from the seeds to each point (Dijkstra 1959): n
/// distances in the model's units, never less than the surface's own; infinite where no path leads.
/// Throws Aborted.
Eigen::VectorXd EdgeGeodesics(
  const Mesh& mesh, const EdgeSeeds& seeds, const Progress& progress = {});

} // namespace shape
