#include "Remesh/IsotropicRemesh.h"

#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr double Long = 4.0 / 3.0, Short = 4.0 / 5.0;
/// A triangle may not turn farther than this when its corners move: the cosine.
constexpr double MinimumCosine = 0.5;
/// Creases of a shorter total length, in edges, are noise.
constexpr double ShortestCrease = 8.0;

using Triangle = std::array<int, 3>;

long long Key(int a, int b)
{
  return (static_cast<long long>(std::min(a, b)) << 32) | std::max(a, b);
}

class Remesher
{
public:
  Remesher(const Surface& surface, const IsotropicRemeshOptions& options)
    : Original(surface)
    , Length(options.EdgeLength)
  {
    const Mesh& mesh = surface;
    for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
    {
      this->Points.emplace_back(mesh.Points.row(i).transpose());
    }
    this->Around.resize(this->Points.size());
    this->CreaseEdges.resize(this->Points.size(), 0);
    for (int t = 0; t < mesh.Triangles.rows(); ++t)
    {
      this->Triangles.push_back(
        { mesh.Triangles(t, 0), mesh.Triangles(t, 1), mesh.Triangles(t, 2) });
      for (const int v : this->Triangles.back())
      {
        this->Around[v].push_back(t);
      }
    }
    this->FindCreases(surface.HalfEdges(), std::cos(options.CreaseAngle * M_PI / 180.0));
  }

  void Split()
  {
    // Halves may be too long, too.
    for (auto edges = this->Edges(Long, true); !edges.empty(); edges = this->Edges(Long, true))
    {
      for (const auto& [a, b] : edges)
      {
        this->SplitEdge(a, b);
      }
    }
  }

  void Collapse()
  {
    for (const auto& [a, b] : this->Edges(Short, false))
    {
      if (!this->Around[a].empty() && !this->Around[b].empty() &&
        this->Distance(a, b) < Short * this->Length)
      {
        this->TryCollapse(a, b) || this->TryCollapse(b, a);
      }
    }
  }

  void Flip()
  {
    for (const auto& [a, b] : this->Edges(0.0, true))
    {
      this->TryFlip(a, b);
    }
  }

  void Slide()
  {
    std::vector<int> moved;
    for (int v = 0; v < static_cast<int>(this->Points.size()); ++v)
    {
      if (!this->Around[v].empty() && this->CreaseEdges[v] == 0)
      {
        moved.push_back(v);
      }
    }
    Eigen::MatrixXd positions(moved.size(), 3);
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      positions.row(i) = this->Slid(moved[i]).transpose();
    }
    positions = this->Original.Find(positions).Positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      const int v = moved[i];
      const Eigen::Vector3d old = this->Points[v];
      const Eigen::Vector3d position = positions.row(i).transpose();
      // Not onto another sheet that happens to be closer.
      if (!this->Turns(v, position, -1) && (position - old).norm() < this->Length)
      {
        this->Points[v] = position;
      }
    }
  }

  Mesh Result() const
  {
    std::vector<int> number(this->Points.size(), -1);
    Mesh mesh;
    int points = 0, triangles = 0;
    for (std::size_t v = 0; v < this->Points.size(); ++v)
    {
      number[v] = this->Around[v].empty() ? -1 : points++;
    }
    mesh.Points.resize(points, 3);
    for (std::size_t v = 0; v < this->Points.size(); ++v)
    {
      if (number[v] >= 0)
      {
        mesh.Points.row(number[v]) = this->Points[v].transpose();
      }
    }
    mesh.Triangles.resize(this->Triangles.size(), 3);
    for (const Triangle& t : this->Triangles)
    {
      if (t[0] >= 0)
      {
        mesh.Triangles.row(triangles++) << number[t[0]], number[t[1]], number[t[2]];
      }
    }
    mesh.Triangles.conservativeResize(triangles, 3);
    return mesh;
  }

private:
  double Distance(int a, int b) const { return (this->Points[a] - this->Points[b]).norm(); }

  Eigen::Vector3d AreaVector(const Triangle& t) const
  {
    return (this->Points[t[1]] - this->Points[t[0]]).cross(this->Points[t[2]] - this->Points[t[0]]);
  }

  void FindCreases(const std::vector<HalfEdge>& sides, double cosine)
  {
    std::vector<std::pair<int, int>> creases;
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
    {
      const Eigen::Vector3d n = this->AreaVector(this->Triangles[sides[i].Triangle]);
      const Eigen::Vector3d m = this->AreaVector(this->Triangles[sides[i + 1].Triangle]);
      if (n.dot(m) < cosine * n.norm() * m.norm())
      {
        creases.emplace_back(sides[i].Low(), sides[i].High());
      }
    }
    // Those that hang together, by union of their ends.
    std::vector<int> root(this->Points.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](int v)
    {
      while (root[v] != v)
      {
        v = root[v] = root[root[v]];
      }
      return v;
    };
    for (const auto& [a, b] : creases)
    {
      root[find(a)] = find(b);
    }
    std::unordered_map<int, double> lengths;
    for (const auto& [a, b] : creases)
    {
      lengths[find(a)] += this->Distance(a, b);
    }
    for (const auto& [a, b] : creases)
    {
      if (lengths[find(a)] >= ShortestCrease * this->Length)
      {
        this->Creases.insert(Key(a, b));
        ++this->CreaseEdges[a];
        ++this->CreaseEdges[b];
      }
    }
  }

  bool OnCrease(int a, int b) const { return this->Creases.count(Key(a, b)) > 0; }

  /// The edges longer, or shorter, than so many lengths; the longest, or shortest, first.
  std::vector<std::pair<int, int>> Edges(double lengths, bool longer) const
  {
    std::vector<std::tuple<double, int, int>> found;
    for (const Triangle& t : this->Triangles)
    {
      for (int k = 0; t[0] >= 0 && k < 3; ++k)
      {
        const int a = t[k], b = t[(k + 1) % 3];
        const double length = this->Distance(a, b);
        if (a < b && (longer ? length > lengths * this->Length : length < lengths * this->Length))
        {
          found.emplace_back(longer ? -length : length, a, b);
        }
      }
    }
    std::sort(found.begin(), found.end());
    std::vector<std::pair<int, int>> edges;
    for (const auto& [length, a, b] : found)
    {
      edges.emplace_back(a, b);
    }
    return edges;
  }

  std::vector<int> TrianglesOf(int a, int b) const
  {
    std::vector<int> both;
    for (const int t : this->Around[a])
    {
      const Triangle& corners = this->Triangles[t];
      if (std::find(corners.begin(), corners.end(), b) != corners.end())
      {
        both.push_back(t);
      }
    }
    return both;
  }

  int Opposite(int t, int a, int b) const
  {
    const Triangle& corners = this->Triangles[t];
    return corners[0] + corners[1] + corners[2] - a - b;
  }

  std::vector<int> Neighbours(int v) const
  {
    std::vector<int> all;
    for (const int t : this->Around[v])
    {
      for (const int u : this->Triangles[t])
      {
        if (u != v)
        {
          all.push_back(u);
        }
      }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  void Drop(int v, int t)
  {
    std::vector<int>& around = this->Around[v];
    around.erase(std::find(around.begin(), around.end(), t));
  }

  void SplitEdge(int a, int b)
  {
    const int m = static_cast<int>(this->Points.size());
    this->Points.push_back(0.5 * (this->Points[a] + this->Points[b]));
    this->Around.emplace_back();
    this->CreaseEdges.push_back(0);
    for (const int t : this->TrianglesOf(a, b))
    {
      const int other = static_cast<int>(this->Triangles.size());
      Triangle first = this->Triangles[t], second = first;
      const int c = this->Opposite(t, a, b);
      std::replace(first.begin(), first.end(), b, m);
      std::replace(second.begin(), second.end(), a, m);
      this->Triangles[t] = first;
      this->Triangles.push_back(second);
      this->Drop(b, t);
      this->Around[b].push_back(other);
      this->Around[c].push_back(other);
      this->Around[m].push_back(t);
      this->Around[m].push_back(other);
    }
    if (this->Creases.erase(Key(a, b)) > 0)
    {
      this->Creases.insert(Key(a, m));
      this->Creases.insert(Key(m, b));
      this->CreaseEdges[m] = 2;
    }
  }

  /// Whether a triangle around v, but those with `except`, would turn too far or become too slim
  /// with v at a place.
  bool Turns(int v, const Eigen::Vector3d& position, int except)
  {
    const Eigen::Vector3d old = this->Points[v];
    for (const int t : this->Around[v])
    {
      const Triangle& corners = this->Triangles[t];
      if (except >= 0 && std::find(corners.begin(), corners.end(), except) != corners.end())
      {
        continue;
      }
      const Eigen::Vector3d before = this->AreaVector(corners);
      this->Points[v] = position;
      const Eigen::Vector3d after = this->AreaVector(corners);
      double longest = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        longest = std::max(longest, this->Distance(corners[k], corners[(k + 1) % 3]));
      }
      this->Points[v] = old;
      const bool wasFlat = before.norm() < 1e-3 * longest * longest;
      if (after.norm() < 0.02 * longest * longest ||
        (!wasFlat && before.dot(after) < MinimumCosine * before.norm() * after.norm()))
      {
        return true;
      }
    }
    return false;
  }

  /// Moves a onto b.
  bool TryCollapse(int a, int b)
  {
    if (this->CreaseEdges[a] > 0 && (this->CreaseEdges[a] != 2 || !this->OnCrease(a, b)))
    {
      return false;
    }
    const std::vector<int> both = this->TrianglesOf(a, b);
    const std::vector<int> ofA = this->Neighbours(a), ofB = this->Neighbours(b);
    std::vector<int> common;
    std::set_intersection(
      ofA.begin(), ofA.end(), ofB.begin(), ofB.end(), std::back_inserter(common));
    if (both.size() != 2 || common.size() != 2)
    {
      return false;
    }
    for (const int u : ofA)
    {
      if (u != b && this->Distance(u, b) > Long * this->Length)
      {
        return false;
      }
    }
    for (const int u : common)
    {
      // Its edges to a and b become one: not two creases, and no point of three neighbours.
      if ((this->OnCrease(a, u) && this->OnCrease(b, u)) || this->Around[u].size() <= 3)
      {
        return false;
      }
    }
    if (this->Turns(a, this->Points[b], b))
    {
      return false;
    }
    for (const int u : ofA)
    {
      if (this->Creases.erase(Key(a, u)) > 0 && u != b)
      {
        this->Creases.insert(Key(b, u));
      }
    }
    this->CreaseEdges[a] = 0; // b has lost the edge to a and has got the other one of a
    for (const int t : both)
    {
      const int c = this->Opposite(t, a, b);
      this->Drop(b, t);
      this->Drop(c, t);
      this->Drop(a, t);
      this->Triangles[t] = { -1, -1, -1 };
    }
    for (const int t : this->Around[a])
    {
      std::replace(this->Triangles[t].begin(), this->Triangles[t].end(), a, b);
      this->Around[b].push_back(t);
    }
    this->Around[a].clear();
    return true;
  }

  /// Turns an edge to the other diagonal of its two triangles, where that makes valences more even
  /// and the surface does not change much.
  void TryFlip(int a, int b)
  {
    if (this->OnCrease(a, b))
    {
      return;
    }
    const std::vector<int> both = this->TrianglesOf(a, b);
    if (both.size() != 2)
    {
      return;
    }
    int t = both[0], s = both[1];
    const Triangle& corners = this->Triangles[t];
    const auto at = std::find(corners.begin(), corners.end(), a) - corners.begin();
    if (corners[(at + 1) % 3] != b)
    {
      std::swap(t, s);
    }
    const int c = this->Opposite(t, a, b), d = this->Opposite(s, a, b);
    if (c == d || !this->TrianglesOf(c, d).empty())
    {
      return;
    }
    const auto excess = [&](int v, int more)
    {
      const int count = static_cast<int>(this->Around[v].size()) + more - 6;
      return count * count;
    };
    const int gain = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0) - excess(a, -1) -
      excess(b, -1) - excess(c, 1) - excess(d, 1);
    const Triangle first = { a, d, c }, second = { d, b, c };
    const Eigen::Vector3d n =
      this->AreaVector(this->Triangles[t]) + this->AreaVector(this->Triangles[s]);
    const Eigen::Vector3d n1 = this->AreaVector(first), n2 = this->AreaVector(second);
    const double minimum = 0.8 * n.norm();
    const double edge = this->Distance(c, d);
    const bool slim = std::min(n1.norm(), n2.norm()) < 0.05 * edge * edge;
    if (gain <= 0 || slim || this->Around[a].size() <= 3 || this->Around[b].size() <= 3 ||
      n1.dot(n) < minimum * n1.norm() || n2.dot(n) < minimum * n2.norm())
    {
      return;
    }
    this->Triangles[t] = first;
    this->Triangles[s] = second;
    this->Drop(b, t);
    this->Drop(a, s);
    this->Around[d].push_back(t);
    this->Around[c].push_back(s);
  }

  /// Where v would be in the middle of its triangles, in its tangent plane.
  Eigen::Vector3d Slid(int v) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
    double weight = 0.0;
    for (const int t : this->Around[v])
    {
      const Triangle& c = this->Triangles[t];
      const Eigen::Vector3d n = this->AreaVector(c);
      sum += n.norm() * (this->Points[c[0]] + this->Points[c[1]] + this->Points[c[2]]) / 3.0;
      weight += n.norm();
      normal += n;
    }
    if (!(weight > 0.0) || !(normal.norm() > 0.0))
    {
      return this->Points[v];
    }
    normal.normalize();
    const Eigen::Vector3d way = sum / weight - this->Points[v];
    return this->Points[v] + way - normal * normal.dot(way);
  }

  SurfaceLocator Original;
  double Length;
  std::vector<Eigen::Vector3d> Points;
  std::vector<Triangle> Triangles; ///< -1 where it is gone
  std::vector<std::vector<int>> Around;
  std::unordered_set<long long> Creases;
  std::vector<int> CreaseEdges; ///< how many of them a point has
};

} // namespace

Mesh RemeshIsotropically(
  const Surface& surface, const IsotropicRemeshOptions& options, const Progress& progress)
{
  if (!std::isfinite(options.EdgeLength) || options.EdgeLength <= 0.0 || options.Rounds < 1)
  {
    throw InvalidInput("EdgeLength must be positive and Rounds at least 1");
  }
  Remesher remesher(surface, options);
  for (int round = 0; round < options.Rounds; ++round)
  {
    remesher.Split();
    remesher.Collapse();
    remesher.Flip();
    remesher.Slide();
    progress((round + 1.0) / options.Rounds);
  }
  return remesher.Result();
}

} // namespace shape
