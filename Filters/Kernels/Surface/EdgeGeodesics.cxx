#include "Surface/EdgeGeodesics.h"

#include "Core/HalfEdges.h"

#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace shape
{
namespace
{

/// The neighbours of each point, each once, and how far they are.
std::vector<std::vector<std::pair<double, int>>> NeighboursOf(const Mesh& mesh)
{
  std::vector<std::vector<std::pair<double, int>>> neighbours(mesh.Points.rows());
  int low = -1, high = -1;
  for (const HalfEdge& edge : SortedHalfEdges(mesh.Triangles, mesh.Points.rows()))
  {
    if (edge.Low() != low || edge.High() != high)
    {
      low = edge.Low();
      high = edge.High();
      const double length = (mesh.Points.row(low) - mesh.Points.row(high)).norm();
      neighbours[low].emplace_back(length, high);
      neighbours[high].emplace_back(length, low);
    }
  }
  return neighbours;
}

} // namespace

Eigen::VectorXd EdgeGeodesics(const Mesh& mesh, const EdgeSeeds& seeds, const Progress& progress)
{
  using Event = std::pair<double, int>;
  const std::vector<std::vector<Event>> neighbours = NeighboursOf(mesh);
  Eigen::VectorXd distances =
    Eigen::VectorXd::Constant(mesh.Points.rows(), std::numeric_limits<double>::infinity());
  std::priority_queue<Event, std::vector<Event>, std::greater<>> queue;
  const auto reach = [&](int point, double distance)
  {
    if (distance < distances(point))
    {
      distances(point) = distance;
      queue.emplace(distance, point);
    }
  };
  for (std::size_t i = 0; i < seeds.Points.size(); ++i)
  {
    reach(seeds.Points[i], seeds.Distances(static_cast<Eigen::Index>(i)));
  }
  constexpr int between = 65536;
  for (int step = 0; !queue.empty(); ++step)
  {
    if (step % between == 0)
    {
      progress(0.0);
    }
    const auto [distance, point] = queue.top();
    queue.pop();
    if (distance <= distances(point))
    {
      for (const auto& [length, other] : neighbours[point])
      {
        reach(other, distance + length);
      }
    }
  }
  progress(1.0);
  return distances;
}

} // namespace shape
