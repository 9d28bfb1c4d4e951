#include "Geodesics/EdgeGeodesics.h"

#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>

namespace shape
{

EdgeGraph::EdgeGraph(const Mesh& mesh)
  : First(mesh.Points.rows() + 1, 0)
{
  std::vector<HalfEdge> once = SortHalfEdges(mesh.Triangles, mesh.Points.rows());
  const auto same = [](const HalfEdge& a, const HalfEdge& b)
  { return a.Low() == b.Low() && a.High() == b.High(); };
  once.erase(std::unique(once.begin(), once.end(), same), once.end());
  for (const HalfEdge& edge : once)
  {
    ++this->First[edge.Begin + 1];
    ++this->First[edge.End + 1];
  }
  for (std::size_t i = 1; i < this->First.size(); ++i)
  {
    this->First[i] += this->First[i - 1];
  }
  this->Edges.resize(2 * once.size());
  std::vector<int> next = this->First;
  for (const HalfEdge& edge : once)
  {
    const double length = (mesh.Points.row(edge.Low()) - mesh.Points.row(edge.High())).norm();
    this->Edges[next[edge.Low()]++] = { length, edge.High() };
    this->Edges[next[edge.High()]++] = { length, edge.Low() };
  }
}

void EdgeGraph::Lower(
  Eigen::VectorXd& distances, const EdgeSeeds& seeds, const Progress& progress) const
{
  std::priority_queue<Edge, std::vector<Edge>, std::greater<>> queue;
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
      for (int i = this->First[point]; i < this->First[point + 1]; ++i)
      {
        reach(this->Edges[i].second, distance + this->Edges[i].first);
      }
    }
  }
}

Eigen::VectorXd ComputeEdgeGeodesics(
  const Mesh& mesh, const EdgeSeeds& seeds, const Progress& progress)
{
  Eigen::VectorXd distances =
    Eigen::VectorXd::Constant(mesh.Points.rows(), std::numeric_limits<double>::infinity());
  EdgeGraph(mesh).Lower(distances, seeds, progress);
  progress(1.0);
  return distances;
}

} // namespace shape
