#include "Remesh/Private/FadingCreases.h"

#include "Mesh/Graph.h"

#include <cmath>
#include <limits>
#include <map>

namespace shape
{
namespace
{

/// Paths go over edges whose normals differ by at least this fraction of the angle.
constexpr double FadingShare = 0.375;
/// A path that meets a crease at a smaller angle, in degrees, would bound too sharp a tip.
constexpr double MinimumTip = 50.0;

/// Finds paths from the ends of creases to other creases, over edges that are less sharp.
class FadingCreases
{
public:
  FadingCreases(const Mesh& mesh, std::vector<Hinge>& hinges, double angle)
    : Hinges(hinges)
  {
    constexpr double straight = 180.0;
    std::map<int, std::vector<int>> edgesAt; // of each point
    for (int i = 0; i < static_cast<int>(hinges.size()); ++i)
    {
      if (hinges[i].Sharp || std::abs(hinges[i].Angle - straight) > FadingShare * angle)
      {
        edgesAt[hinges[i].Low].push_back(i);
        edgesAt[hinges[i].High].push_back(i);
      }
    }
    std::vector<int> points;
    std::map<int, int> nodeOf;
    for (const auto& [point, edges] : edgesAt)
    {
      nodeOf[point] = static_cast<int>(points.size());
      points.push_back(point);
    }
    this->Positions = mesh.Points(points, Eigen::all);
    this->Links.First.push_back(0);
    for (const auto& [point, edges] : edgesAt)
    {
      for (const int edge : edges)
      {
        this->Links.Neighbours.push_back(
          nodeOf[hinges[edge].Low == point ? hinges[edge].High : hinges[edge].Low]);
        this->Links.Lengths.push_back(hinges[edge].Length);
        this->HingeOf.push_back(edge);
      }
      this->Links.First.push_back(static_cast<int>(this->HingeOf.size()));
    }
    this->Distances =
      Eigen::VectorXd::Constant(this->Links.Size(), std::numeric_limits<double>::infinity());
    this->Before.assign(this->Links.Size(), -1);
  }

  void Extend()
  {
    for (int node = 0; node < this->Links.Size(); ++node)
    {
      if (this->CountCreases(node) == 1)
      {
        this->ExtendFrom(node);
      }
    }
  }

private:
  bool IsCrease(int link) const { return this->Hinges[this->HingeOf[link]].IsCrease; }

  int CountCreases(int node) const
  {
    int count = 0;
    for (int k = this->Links.First[node]; k < this->Links.First[node + 1]; ++k)
    {
      count += this->IsCrease(k) ? 1 : 0;
    }
    return count;
  }

  /// Marks the shortest path to the closest point on a crease.
  void ExtendFrom(int end)
  {
    std::vector<int> reached;
    int target = -1;
    RunDijkstra(
      this->Links, { { end }, Eigen::VectorXd::Zero(1) }, this->Distances,
      [&](double distance, int link)
      {
        return this->IsCrease(link) ? std::numeric_limits<double>::infinity()
                                    : distance + this->Links.Lengths[link];
      },
      [&](int node, int before)
      {
        this->Before[node] = before;
        reached.push_back(node);
      },
      [&](int node)
      {
        target = node != end && this->CountCreases(node) > 0 ? node : -1;
        return target >= 0;
      });
    if (target >= 0 && !this->IsTip(target, end))
    {
      this->MarkPath(target);
    }
    for (const int node : reached)
    {
      this->Distances(node) = std::numeric_limits<double>::infinity();
    }
  }

  /// Follows a crease from a node until it is at least `length` away, or forks.
  Eigen::RowVector3d Chord(int node, int link, double length) const
  {
    const Eigen::RowVector3d begin = this->Positions.row(node);
    node = this->Links.Neighbours[link];
    constexpr int maximum = 1000; // edges of a closed crease that stays near
    for (int i = 0; i < maximum && (this->Positions.row(node) - begin).norm() < length &&
         this->CountCreases(node) == 2;
         ++i)
    {
      const int last = this->HingeOf[link];
      link = this->Links.First[node];
      while (this->HingeOf[link] == last || !this->IsCrease(link))
      {
        ++link;
      }
      node = this->Links.Neighbours[link];
    }
    return this->Positions.row(node) - begin;
  }

  /// The path and the crease are compared over the same length, not by their first edges.
  bool IsTip(int node, int end) const
  {
    const Eigen::RowVector3d way = this->Positions.row(end) - this->Positions.row(node);
    for (int k = this->Links.First[node]; k < this->Links.First[node + 1]; ++k)
    {
      if (this->IsCrease(k) &&
        this->Chord(node, k, way.norm()).normalized().dot(way.normalized()) >
          std::cos(MinimumTip * M_PI / 180.0))
      {
        return true;
      }
    }
    return false;
  }

  /// Turns the edges along the path to a node into creases.
  void MarkPath(int node)
  {
    for (; this->Before[node] >= 0; node = this->Before[node])
    {
      for (int k = this->Links.First[node]; k < this->Links.First[node + 1]; ++k)
      {
        if (this->Links.Neighbours[k] == this->Before[node])
        {
          this->Hinges[this->HingeOf[k]].IsCrease = true;
        }
      }
    }
  }

  std::vector<Hinge>& Hinges;
  Graph Links;              ///< edges that are sharp, or nearly so, and their points
  std::vector<int> HingeOf; ///< of each link
  Eigen::MatrixXd Positions;
  Eigen::VectorXd Distances; ///< infinite between searches
  std::vector<int> Before;   ///< for each reached node, the previous one on the path
};

} // namespace

void ExtendFadingCreases(const Mesh& mesh, double angle, std::vector<Hinge>& hinges)
{
  FadingCreases(mesh, hinges, angle).Extend();
}

} // namespace shape
