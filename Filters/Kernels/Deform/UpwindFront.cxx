#include "Deform/UpwindFront.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

namespace shape
{
/// f(x, r) = max((1 - x^2 / r^2)^3, 0), section 2.1.
double EvaluateSmoothFalloff(double x, double radius)
{
  const double ratio = x / radius;
  const double rest = std::max(1.0 - ratio * ratio, 0.0);
  return rest * rest * rest;
}

double EvaluateInverseDistanceWeight(double distance, double power)
{
  // Inside the power, epsilon acts at the same distance, a thousandth of a link, whatever the
  // power.
  const double square = distance * distance + 1e-6;
  return 1.0 / (power == 2.0 ? square : std::pow(square, 0.5 * power));
}

/// The arrival times of section 2.1, by Dijkstra's algorithm from all sources at once.
FrontSweep SweepFront(
  const PointGraph& graph, const std::vector<int>& sources, const Progress& progress)
{
  const int n = graph.Size();
  constexpr double never = std::numeric_limits<double>::infinity();
  std::vector<double> arrivals(n, never), steps(n, 0.0);
  std::vector<int> parents(n, -1);
  std::vector<char> done(n, 0);
  // For equal times the queue orders by node, so the ranks are unique.
  using Item = std::pair<double, int>; // arrival, node
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  FrontSweep sweep;
  sweep.Sources = static_cast<int>(sources.size());
  sweep.Nodes = sources;
  for (const int source : sources)
  {
    arrivals[source] = 0.0;
    done[source] = 1;
  }
  const auto spread = [&](int node)
  {
    for (int k = graph.First[node]; k < graph.First[node + 1]; ++k)
    {
      const int next = graph.Neighbours[k];
      const double arrival = arrivals[node] + graph.Lengths[k];
      if (!done[next] && arrival < arrivals[next])
      {
        arrivals[next] = arrival;
        parents[next] = node;
        steps[next] = graph.Lengths[k];
        queue.emplace(arrival, next);
      }
    }
  };
  for (const int source : sources)
  {
    spread(source);
  }
  for (int step = 0; !queue.empty(); ++step)
  {
    if (step % 65536 == 0)
    {
      progress(static_cast<double>(sweep.Nodes.size()) / n);
    }
    const int node = queue.top().second;
    queue.pop();
    if (!done[node])
    {
      done[node] = 1;
      sweep.Nodes.push_back(node);
      spread(node);
    }
  }
  if (static_cast<int>(sweep.Nodes.size()) < n)
  {
    throw InvalidInput("the front does not reach " +
      std::to_string(n - static_cast<int>(sweep.Nodes.size())) +
      " points; connect them to the sources");
  }
  sweep.Ranks.resize(n);
  for (int rank = 0; rank < n; ++rank)
  {
    sweep.Ranks[sweep.Nodes[rank]] = rank;
  }
  for (const int node : sweep.Nodes)
  {
    sweep.Arrivals.push_back(arrivals[node]);
    sweep.Parents.push_back(parents[node] < 0 ? -1 : sweep.Ranks[parents[node]]);
    sweep.Steps.push_back(steps[node]);
  }
  progress(1.0);
  return sweep;
}

UpwindFront::UpwindFront(const PointGraph& graph, const FrontSweep& sweep,
  const Eigen::VectorXd& powers, const UpwindFrontOptions& options)
  : Graph(graph)
  , Sweep(sweep)
  , Radius(options.Radius * graph.MeanLength)
  , Distance(options.Distance)
{
  const int n = graph.Size();
  this->Begins.resize(n, 0);
  this->Ends.resize(n, 0);
  this->Positions.resize(3, n);
  for (int rank = 0; rank < n; ++rank)
  {
    const int node = sweep.Nodes[rank];
    this->Powers.push_back(powers(node));
    this->Weights.push_back(graph.Weights(node));
    this->Positions.col(rank) = graph.Positions.row(node).transpose();
  }
  int end = sweep.Sources;
  // Omega(p_i) of section 2.1: arrival times in (g_i - r_u, g_i). Ranks are ordered by time, so the
  // band is a range of ranks.
  for (int rank = sweep.Sources; rank < n; ++rank)
  {
    const double arrival = sweep.Arrivals[rank];
    // Nodes that arrive at the same time are not upwind of each other.
    end = sweep.Arrivals[end] < arrival ? rank : end;
    // A node that coincides with a source has a step of length 0: the sources are its band anyway.
    this->Ends[rank] = end;
    this->Empty += sweep.Arrivals[end - 1] <= arrival - this->Radius;
    // A link longer than the radius would leave the band empty. A quarter more gives its start a
    // weight.
    const auto begin = std::upper_bound(sweep.Arrivals.begin(), sweep.Arrivals.begin() + end - 1,
      arrival - std::max(this->Radius, 1.25 * sweep.Steps[rank]));
    this->Begins[rank] = static_cast<int>(begin - sweep.Arrivals.begin());
  }
}

/// d of equation 4: Euclidean, or by Dijkstra's algorithm inside the band (end of section 2.1).
void UpwindFront::FindDistances(int rank, double* distances) const
{
  const int begin = this->Begins[rank], end = this->Ends[rank];
  if (this->Distance == FrontDistance::Euclidean)
  {
    const Eigen::Vector3d position = this->Positions.col(rank);
    for (int j = begin; j < end; ++j)
    {
      distances[j - begin] = (this->Positions.col(j) - position).norm();
    }
    return;
  }
  std::fill(distances, distances + (end - begin), std::numeric_limits<double>::infinity());
  using Item = std::pair<double, int>; // distance, rank
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  const auto spread = [&](int from, double distance)
  {
    const int node = this->Sweep.Nodes[from];
    for (int k = this->Graph.First[node]; k < this->Graph.First[node + 1]; ++k)
    {
      const int to = this->Sweep.Ranks[this->Graph.Neighbours[k]];
      const double farther = distance + this->Graph.Lengths[k];
      if (to >= begin && to < end && farther < distances[to - begin])
      {
        distances[to - begin] = farther;
        queue.emplace(farther, to);
      }
    }
  };
  spread(rank, 0.0);
  while (!queue.empty())
  {
    const auto [distance, next] = queue.top();
    queue.pop();
    if (distance <= distances[next - begin])
    {
      spread(next, distance);
    }
  }
}

bool UpwindFront::Row(int rank, float* weights) const
{
  const int begin = this->Begins[rank], count = this->Ends[rank] - begin;
  const int node = this->Sweep.Nodes[rank];
  const double arrival = this->Sweep.Arrivals[rank];
  const double radius = std::max(this->Radius, 1.25 * this->Sweep.Steps[rank]);
  // r_n of equation 6, with the shortest link as the nearest point.
  const double nearest = *std::min_element(this->Graph.Lengths.begin() + this->Graph.First[node],
    this->Graph.Lengths.begin() + this->Graph.First[node + 1]);
  std::vector<double> row(count);
  this->FindDistances(rank, row.data());
  double largest = 0.0;
  for (int j = 0; j < count; ++j)
  {
    const double before = arrival - this->Sweep.Arrivals[begin + j];
    // Equation 9: w_arr (equation 7) times w_reg (equation 8, the area of the node) times w
    // (equation 4).
    row[j] = EvaluateSmoothFalloff(before, radius) *
      (1.0 - EvaluateSmoothFalloff(before, nearest)) * this->Weights[begin + j] *
      EvaluateInverseDistanceWeight(row[j] / this->Graph.MeanLength, this->Powers[rank]);
    largest = std::max(largest, row[j]);
  }
  const int parent = this->Sweep.Parents[rank] - begin;
  const bool some = largest > 0.0;
  for (int j = 0; j < count; ++j)
  {
    weights[j] = some ? static_cast<float>(row[j] / largest) : static_cast<float>(j == parent);
  }
  return some;
}

} // namespace shape
