#include "Hex/Features/Private/CornerValenceMatching.h"

#include "Hex/Features/PatchRings.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/successive_shortest_path_nonnegative_weights.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

struct FlowArc;
using FlowTraits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using FlowGraph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property, FlowArc>;

struct FlowArc
{
  int Capacity = 0, Residual = 0;
  double Cost = 0.0;
  FlowTraits::edge_descriptor Reverse;
};

/// Finds paths of minimum total cost from one node to each of several others; no other node is on
/// two paths. A minimum-cost flow (Boost.Graph: successive shortest paths) in the graph whose nodes
/// are split into an entry (2 i) and an exit (2 i + 1).
class DisjointPaths
{
public:
  /// nodes: their number. largest: an upper bound of the costs.
  DisjointPaths(int nodes, double largest)
    : Graph(2 * static_cast<std::size_t>(nodes) + 1)
    , Unit(std::ldexp(largest, -32))
  {
  }

  void AddNode(int node, double cost) { this->AddArc(2 * node, 2 * node + 1, cost); }
  void AddEdge(int a, int b, double cost)
  {
    this->AddArc(2 * a + 1, 2 * b, cost);
    this->AddArc(2 * b + 1, 2 * a, cost);
  }
  void AddEnd(int node) { this->AddArc(2 * node + 1, this->Sink(), 0.0); }

  /// Returns the successor of each node on the paths; nothing if an end is not reached.
  std::optional<std::vector<std::pair<int, int>>> Find(int from)
  {
    boost::successive_shortest_path_nonnegative_weights(this->Graph, 2 * from + 1, this->Sink(),
      boost::capacity_map(get(&FlowArc::Capacity, this->Graph))
        .residual_capacity_map(get(&FlowArc::Residual, this->Graph))
        .weight_map(get(&FlowArc::Cost, this->Graph))
        .reverse_edge_map(get(&FlowArc::Reverse, this->Graph)));
    std::vector<std::pair<int, int>> steps;
    for (const auto arc : boost::make_iterator_range(edges(this->Graph)))
    {
      const auto begin = static_cast<int>(source(arc, this->Graph)),
                 end = static_cast<int>(target(arc, this->Graph));
      const bool isUsed = this->Graph[arc].Capacity > this->Graph[arc].Residual;
      if (end == this->Sink() && !isUsed)
      {
        return std::nullopt;
      }
      if (end != this->Sink() && begin % 2 == 1 && isUsed)
      {
        steps.emplace_back(begin / 2, end / 2);
      }
    }
    return steps;
  }

private:
  int Sink() const { return static_cast<int>(num_vertices(this->Graph)) - 1; }

  void AddArc(int from, int to, double cost)
  {
    // Integers: rounding must not make the reduced cost of an arc negative.
    const double whole = this->Unit > 0.0 ? std::round(cost / this->Unit) : 0.0;
    const auto ahead = add_edge(from, to, this->Graph).first;
    const auto back = add_edge(to, from, this->Graph).first;
    this->Graph[ahead] = { 1, 0, whole, back };
    this->Graph[back] = { 0, 0, -whole, ahead };
  }

  FlowGraph Graph;
  const double Unit; ///< the unit of integer costs
};

class Gathering
{
public:
  Gathering(const Eigen::MatrixXd& points, const QuadSurface& quads, const Mesh& surface,
    const SurfaceFeatures& features, Eigen::VectorXi& patchOf)
    : Points(points)
    , Boundary(quads)
    , Quads(quads.Quads())
    , Surface(surface)
    , Features(features)
    , QuadsAt(points.rows())
    , PatchOf(patchOf)
    , Taken(points.rows(), 0)
  {
    for (int q = 0; q < static_cast<int>(this->Quads.rows()); ++q)
    {
      for (const int point : this->Quads.row(q))
      {
        this->QuadsAt[point].push_back(q);
      }
    }
  }

  void Run()
  {
    const std::vector<PatchRing> rings = FindCornerRings(this->Surface, this->Features);
    std::vector<int> missing;
    for (int corner = 0; corner < static_cast<int>(rings.size()); ++corner)
    {
      if (!this->FindPoint(corner, rings[corner]))
      {
        missing.push_back(corner);
      }
    }
    for (const int corner : missing)
    {
      this->Gather(corner, rings[corner]);
    }
  }

private:
  Eigen::RowVector3d Position(int corner) const
  {
    return this->Surface.Points.row(this->Features.Corners[corner]);
  }

  /// Returns the points of the quads, those closest to a corner first.
  std::vector<int> Nearest(int corner) const
  {
    std::vector<std::pair<double, int>> order;
    for (int point = 0; point < static_cast<int>(this->QuadsAt.size()); ++point)
    {
      if (!this->QuadsAt[point].empty())
      {
        order.emplace_back((this->Points.row(point) - this->Position(corner)).norm(), point);
      }
    }
    constexpr std::size_t maximum = 200;
    const auto last = order.begin() + static_cast<std::ptrdiff_t>(std::min(maximum, order.size()));
    std::partial_sort(order.begin(), last, order.end());
    std::vector<int> nearest;
    std::transform(order.begin(), last, std::back_inserter(nearest),
      [](const auto& entry) { return entry.second; });
    return nearest;
  }

  PatchRing RingAt(int point) const
  {
    std::vector<int> labels;
    for (const int quad : this->Boundary.QuadsAround(point, this->QuadsAt[point].front()))
    {
      labels.push_back(this->PatchOf(quad));
    }
    return BuildPatchRing(labels);
  }

  bool FindPoint(int corner, const PatchRing& ring)
  {
    for (const int point : this->Nearest(corner))
    {
      if (!this->Taken[point] && this->RingAt(point) == ring)
      {
        this->Taken[point] = 1;
        return true;
      }
    }
    return false;
  }

  void Gather(int corner, const PatchRing& ring)
  {
    constexpr int tries = 40, largest = 6; // points, rings of quads
    int tried = 0;
    for (const int point : this->Nearest(corner))
    {
      if (this->QuadsAt[point].size() < ring.size() || this->Taken[point])
      {
        continue;
      }
      std::set<int> disc(this->QuadsAt[point].begin(), this->QuadsAt[point].end());
      for (int radius = 1; radius <= largest; ++radius)
      {
        this->Grow(disc);
        if (this->Gather(point, disc, ring))
        {
          this->Taken[point] = 1;
          return;
        }
      }
      if (++tried == tries)
      {
        return;
      }
    }
  }

  void Grow(std::set<int>& disc) const
  {
    const std::set<int> before = disc;
    for (const int quad : before)
    {
      for (const int point : this->Quads.row(quad))
      {
        disc.insert(this->QuadsAt[point].begin(), this->QuadsAt[point].end());
      }
    }
  }

  /// Returns the boundary loop of a disk, counter-clockwise; empty if it is not one simple closed
  /// chain, or if a point inside belongs to a corner.
  std::vector<int> LoopOf(const std::set<int>& disc) const
  {
    std::map<int, int> next;
    std::size_t edges = 0;
    for (const int quad : disc)
    {
      for (int k = 0; k < 4; ++k)
      {
        const int a = this->Quads(quad, k), b = this->Quads(quad, (k + 1) % 4);
        if (this->Taken[a])
        {
          return {};
        }
        if (disc.count(this->Boundary.QuadAt({ b, a })) == 0)
        {
          next[a] = b;
          ++edges;
        }
      }
    }
    if (next.empty() || next.size() != edges)
    {
      return {};
    }
    std::vector<int> loop = { next.begin()->first };
    while (next.at(loop.back()) != loop.front())
    {
      loop.push_back(next.at(loop.back()));
    }
    return loop.size() == edges ? loop : std::vector<int>();
  }

  /// Returns the points of the loop at which the patches outside the disk change; nothing if the
  /// patches outside are not those of the ring.
  std::optional<std::vector<int>> Ends(const std::vector<int>& loop, const PatchRing& ring) const
  {
    std::vector<int> ends, labels;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const int before = loop[(i + loop.size() - 1) % loop.size()], point = loop[i];
      const int after = loop[(i + 1) % loop.size()];
      const int last = this->Boundary.QuadAt({ after, point });
      int quad = this->Boundary.QuadAt({ point, before }), changes = 0;
      labels.push_back(this->PatchOf(quad));
      while (quad != last)
      {
        const int following = this->Boundary.NextAround(point, quad);
        changes += this->PatchOf(following) != this->PatchOf(quad);
        quad = following;
      }
      if (changes > 1)
      {
        return std::nullopt;
      }
      if (changes == 1)
      {
        ends.push_back(point);
      }
    }
    return BuildPatchRing(labels) == ring ? std::optional(ends) : std::nullopt;
  }

  /// Routes chains from the point to the loop and assigns the quads between them.
  bool Gather(int point, const std::set<int>& disc, const PatchRing& ring)
  {
    const std::vector<int> loop = this->LoopOf(disc);
    if (loop.empty())
    {
      return false;
    }
    const auto ends = this->Ends(loop, ring);
    if (!ends || ends->size() != ring.size())
    {
      return false;
    }
    const auto chains = this->Chains(point, disc, loop, *ends);
    if (!chains)
    {
      return false;
    }
    this->Fill(disc, *chains);
    return true;
  }

  std::optional<std::set<QuadEdge>> Chains(int point, const std::set<int>& disc,
    const std::vector<int>& loop, const std::vector<int>& ends) const
  {
    std::map<int, int> number;
    std::vector<int> points;
    for (const int quad : disc)
    {
      for (const int own : this->Quads.row(quad))
      {
        if (number.emplace(own, static_cast<int>(points.size())).second)
        {
          points.push_back(own);
        }
      }
    }
    const std::set<int> onLoop(loop.begin(), loop.end());
    std::vector<double> nodeCosts;
    std::transform(points.begin(), points.end(), std::back_inserter(nodeCosts),
      [&](int own) { return this->DistanceToCurves(own); });
    std::map<QuadEdge, double> edgeCosts;
    for (const int quad : disc)
    {
      for (int k = 0; k < 4; ++k)
      {
        const int a = this->Quads(quad, k), b = this->Quads(quad, (k + 1) % 4);
        if (a < b && disc.count(this->Boundary.QuadAt({ b, a })) > 0 &&
          (onLoop.count(a) == 0 || onLoop.count(b) == 0))
        {
          edgeCosts[{ number.at(a), number.at(b) }] =
            (this->Points.row(a) - this->Points.row(b)).norm();
        }
      }
    }
    double largest = *std::max_element(nodeCosts.begin(), nodeCosts.end());
    for (const auto& [edge, cost] : edgeCosts)
    {
      largest = std::max(largest, cost);
    }
    DisjointPaths paths(static_cast<int>(points.size()), largest);
    for (std::size_t node = 0; node < nodeCosts.size(); ++node)
    {
      paths.AddNode(static_cast<int>(node), nodeCosts[node]);
    }
    for (const auto& [edge, cost] : edgeCosts)
    {
      paths.AddEdge(edge.first, edge.second, cost);
    }
    for (const int end : ends)
    {
      paths.AddEnd(number.at(end));
    }
    const auto steps = paths.Find(number.at(point));
    if (!steps)
    {
      return std::nullopt;
    }
    std::set<QuadEdge> chains;
    for (const auto& [a, b] : *steps)
    {
      chains.insert({ points[a], points[b] });
      chains.insert({ points[b], points[a] });
    }
    return chains;
  }

  double DistanceToCurves(int point) const
  {
    double minimum = std::numeric_limits<double>::infinity();
    for (const FeatureCurve& curve : this->Features.Curves)
    {
      const std::size_t count = curve.Points.size();
      for (std::size_t i = 0; i + (curve.Closed ? 0 : 1) < count; ++i)
      {
        const Eigen::RowVector3d a = this->Surface.Points.row(curve.Points[i]);
        const Eigen::RowVector3d along =
          this->Surface.Points.row(curve.Points[(i + 1) % count]) - a;
        const Eigen::RowVector3d from = this->Points.row(point) - a;
        const double share =
          std::clamp(from.dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
        minimum = std::min(minimum, (from - share * along).norm());
      }
    }
    return minimum;
  }

  void Fill(const std::set<int>& disc, const std::set<QuadEdge>& chains)
  {
    std::map<int, int> label;
    std::vector<int> open;
    for (const int quad : disc)
    {
      for (int k = 0; k < 4; ++k)
      {
        const int beyond =
          this->Boundary.QuadAt({ this->Quads(quad, (k + 1) % 4), this->Quads(quad, k) });
        if (disc.count(beyond) == 0 && label.emplace(quad, this->PatchOf(beyond)).second)
        {
          open.push_back(quad);
        }
      }
    }
    for (std::size_t i = 0; i < open.size(); ++i)
    {
      const int quad = open[i];
      for (int k = 0; k < 4; ++k)
      {
        const QuadEdge edge = { this->Quads(quad, (k + 1) % 4), this->Quads(quad, k) };
        const int beyond = this->Boundary.QuadAt(edge);
        if (disc.count(beyond) > 0 && chains.count(edge) == 0 &&
          label.emplace(beyond, label.at(quad)).second)
        {
          open.push_back(beyond);
        }
      }
    }
    for (const auto& [quad, patch] : label)
    {
      this->PatchOf(quad) = patch;
    }
  }

  const Eigen::MatrixXd& Points;
  const QuadSurface& Boundary;
  const Eigen::MatrixXi& Quads;
  const Mesh& Surface;
  const SurfaceFeatures& Features;
  std::vector<std::vector<int>> QuadsAt;
  Eigen::VectorXi& PatchOf;
  std::vector<char> Taken; ///< marks points that belong to corners
};

} // namespace

void MatchCornerValences(const Eigen::MatrixXd& points, const QuadSurface& quads,
  const Mesh& surface, const SurfaceFeatures& features, Eigen::VectorXi& patchOf)
{
  Gathering(points, quads, surface, features, patchOf).Run();
}

} // namespace shape
