#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// Points that distances begin at, and how far each is from where they are counted from.
struct EdgeSeeds
{
  std::vector<int> Points;
  Eigen::VectorXd Distances;
};

/// The edges of a surface and their lengths, along which distances from many seeds are found.
class EdgeGraph
{
public:
  explicit EdgeGraph(const Mesh& mesh);

  /// Lowers distances (n) to those from more seeds where these are nearer (Dijkstra 1959): it goes
  /// no farther than that. Throws Aborted.
  void Lower(
    Eigen::VectorXd& distances, const EdgeSeeds& seeds, const Progress& progress = {}) const;

private:
  using Edge = std::pair<double, int>; ///< its length and where it leads
  std::vector<int> First;              ///< edges from point i: from First[i] to First[i + 1]
  std::vector<Edge> Edges;
};

/// The length of the shortest path along edges from the seeds to each point: n distances in the
/// model's units, never less than the surface's own; infinite where no path leads. Throws Aborted.
Eigen::VectorXd ComputeEdgeGeodesics(
  const Mesh& mesh, const EdgeSeeds& seeds, const Progress& progress = {});

} // namespace shape
