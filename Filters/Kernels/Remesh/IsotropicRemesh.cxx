#include "Remesh/IsotropicRemesh.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"
#include "Remesh/EditableSurface.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The thresholds of Botsch and Kobbelt 2004, in wanted lengths. An edge is split if its
/// halves are closer to the wanted length: 4/3 - 1 = 1 - 2/3. It is collapsed if the edges around
/// it, which become longer by half of it, are then closer: 1 - 4/5 = 6/5 - 1.
constexpr double Long = 4.0 / 3.0, Short = 4.0 / 5.0;
/// The cosine of the largest angle by which a triangle may rotate when its corners move.
constexpr double MinimumCosine = 0.5;
/// Connected creases of a shorter total length, in edges, are noise.
constexpr double ShortestCrease = 8.0;

using Triangle = EditableSurface::Triangle;

long long Key(int a, int b)
{
  return (static_cast<long long>(std::min(a, b)) << 32) | std::max(a, b);
}

/// One round is Split, Collapse, Flip and Slide, in this order; after the last one take the Result.
class Remesher
{
public:
  Remesher(const Surface& surface, const IsotropicRemeshOptions& options)
    : Original(surface)
    , Length(options.EdgeLength)
    , Edited(surface)
    , CreaseEdges(surface.Points().rows(), 0)
  {
    this->FindCreases(surface.HalfEdges(), std::cos(options.CreaseAngle * M_PI / 180.0));
  }

  /// Step 1: splits edges that are too long, the longest first.
  void Split()
  {
    // The halves may still be too long.
    for (auto edges = this->Edges(Long, true); !edges.empty(); edges = this->Edges(Long, true))
    {
      for (const auto& [a, b] : edges)
      {
        this->SplitEdge(a, b);
      }
    }
  }

  /// Step 2: collapses edges that are too short, the shortest first. Both ends are tried.
  void Collapse()
  {
    for (const auto& [a, b] : this->Edges(Short, false))
    {
      if (this->Edited.Contains(a) && this->Edited.Contains(b) &&
        this->Edited.Length(a, b) < Short * this->Length)
      {
        this->TryCollapse(a, b) || this->TryCollapse(b, a);
      }
    }
  }

  /// Step 3: flips edges to bring valences closer to 6.
  void Flip()
  {
    for (const auto& [a, b] : this->Edges(0.0, true))
    {
      this->TryFlip(a, b);
    }
  }

  /// Step 4: tangential relaxation. Points move to the centroid of the triangles around them in the
  /// tangent plane, then to the closest point of the original surface.
  void Slide()
  {
    std::vector<int> moved;
    for (int v = 0; v < this->Edited.PointCount(); ++v)
    {
      if (this->Edited.Contains(v) && this->CreaseEdges[v] == 0)
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
      const Eigen::Vector3d position = positions.row(i).transpose();
      // Not onto another sheet that happens to be closer.
      if (!this->Turns(v, position, -1) &&
        (position - this->Edited.Position(v)).norm() < this->Length)
      {
        this->Edited.Move(v, position);
      }
    }
  }

  Mesh Result() const { return this->Edited.Compact().Surface; }

private:
  void FindCreases(const std::vector<HalfEdge>& sides, double cosine)
  {
    std::vector<std::pair<int, int>> creases;
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
    {
      const Eigen::Vector3d n = this->Edited.AreaVector(this->Edited.Corners(sides[i].Triangle));
      const Eigen::Vector3d m =
        this->Edited.AreaVector(this->Edited.Corners(sides[i + 1].Triangle));
      if (n.dot(m) < cosine * n.norm() * m.norm())
      {
        creases.emplace_back(sides[i].Low(), sides[i].High());
      }
    }
    // Connected ones are joined by their ends.
    DisjointSets curves(this->Edited.PointCount());
    for (const auto& [a, b] : creases)
    {
      curves.Merge(a, b);
    }
    std::unordered_map<int, double> lengths;
    for (const auto& [a, b] : creases)
    {
      lengths[curves.Find(a)] += this->Edited.Length(a, b);
    }
    for (const auto& [a, b] : creases)
    {
      if (lengths[curves.Find(a)] >= ShortestCrease * this->Length)
      {
        this->Creases.insert(Key(a, b));
        ++this->CreaseEdges[a];
        ++this->CreaseEdges[b];
      }
    }
  }

  bool OnCrease(int a, int b) const { return this->Creases.count(Key(a, b)) > 0; }

  /// The edges longer, or shorter, than `lengths` times the wanted length; the longest, or
  /// shortest, first.
  std::vector<std::pair<int, int>> Edges(double lengths, bool longer) const
  {
    std::vector<std::tuple<double, int, int>> found;
    for (int triangle = 0; triangle < this->Edited.TriangleCount(); ++triangle)
    {
      const Triangle& t = this->Edited.Corners(triangle);
      for (int k = 0; t[0] >= 0 && k < 3; ++k)
      {
        const int a = t[k], b = t[(k + 1) % 3];
        const double length = this->Edited.Length(a, b);
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

  void SplitEdge(int a, int b)
  {
    const int middle = this->Edited.Split(a, b);
    this->CreaseEdges.push_back(0);
    if (this->Creases.erase(Key(a, b)) > 0)
    {
      this->Creases.insert(Key(a, middle));
      this->Creases.insert(Key(middle, b));
      this->CreaseEdges[middle] = 2;
    }
  }

  /// Whether moving v to a position would rotate a triangle around it too far or make it a sliver;
  /// triangles with `except` are ignored.
  bool Turns(int v, const Eigen::Vector3d& position, int except)
  {
    const Eigen::Vector3d old = this->Edited.Position(v);
    for (const int t : this->Edited.Around(v))
    {
      const Triangle& corners = this->Edited.Corners(t);
      if (except >= 0 && EditableSurface::Has(corners, except))
      {
        continue;
      }
      const Eigen::Vector3d before = this->Edited.AreaVector(corners);
      this->Edited.Move(v, position);
      const Eigen::Vector3d after = this->Edited.AreaVector(corners);
      double longest = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        longest = std::max(longest, this->Edited.Length(corners[k], corners[(k + 1) % 3]));
      }
      this->Edited.Move(v, old);
      const bool wasFlat = before.norm() < 1e-3 * longest * longest;
      if (after.norm() < 0.02 * longest * longest ||
        (!wasFlat && before.dot(after) < MinimumCosine * before.norm() * after.norm()))
      {
        return true;
      }
    }
    return false;
  }

  /// Merges a into b.
  bool TryCollapse(int a, int b)
  {
    // A point on a crease only merges along it; corners and ends of creases stay.
    if (this->CreaseEdges[a] > 0 && (this->CreaseEdges[a] != 2 || !this->OnCrease(a, b)))
    {
      return false;
    }
    std::vector<int> ofA, ofB, common;
    this->Edited.FindNeighbours(a, ofA);
    this->Edited.FindNeighbours(b, ofB);
    std::set_intersection(
      ofA.begin(), ofA.end(), ofB.begin(), ofB.end(), std::back_inserter(common));
    // The link condition: no common neighbours except those of the edge's two triangles.
    if (this->Edited.TrianglesOf(a, b).size() != 2 || common.size() != 2)
    {
      return false;
    }
    for (const int u : ofA)
    {
      // The collapse must not make an edge that the next round splits.
      if (u != b && this->Edited.Length(u, b) > Long * this->Length)
      {
        return false;
      }
    }
    for (const int u : common)
    {
      // Its edges to a and b become one: not two creases, and no point of three neighbours.
      if ((this->OnCrease(a, u) && this->OnCrease(b, u)) || this->Edited.Around(u).size() <= 3)
      {
        return false;
      }
    }
    if (this->Turns(a, this->Edited.Position(b), b))
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
    this->Edited.Collapse(a, b);
    return true;
  }

  /// Flips an edge if that equalises the valences and hardly changes the surface.
  void TryFlip(int a, int b)
  {
    if (this->OnCrease(a, b))
    {
      return;
    }
    const std::vector<int> both = this->Edited.TrianglesOf(a, b);
    if (both.size() != 2)
    {
      return;
    }
    int t = both[0], s = both[1];
    const Triangle& corners = this->Edited.Corners(t);
    if (corners[(EditableSurface::CornerOf(corners, a) + 1) % 3] != b)
    {
      std::swap(t, s);
    }
    const int c = this->Edited.Opposite(t, a, b), d = this->Edited.Opposite(s, a, b);
    if (c == d || !this->Edited.TrianglesOf(c, d).empty())
    {
      return;
    }
    // The squared deviation from valence 6. The flip removes a triangle at a and b and adds one at
    // c and d.
    const auto excess = [&](int v, int more)
    {
      const int count = static_cast<int>(this->Edited.Around(v).size()) + more - 6;
      return count * count;
    };
    const int gain = excess(a, 0) + excess(b, 0) + excess(c, 0) + excess(d, 0) - excess(a, -1) -
      excess(b, -1) - excess(c, 1) - excess(d, 1);
    const Eigen::Vector3d n = this->Edited.AreaVector(this->Edited.Corners(t)) +
      this->Edited.AreaVector(this->Edited.Corners(s));
    const Eigen::Vector3d n1 = this->Edited.AreaVector({ a, d, c }),
                          n2 = this->Edited.AreaVector({ d, b, c });
    const double minimum = 0.8 * n.norm();
    const double edge = this->Edited.Length(c, d);
    const bool slim = std::min(n1.norm(), n2.norm()) < 0.05 * edge * edge;
    if (gain <= 0 || slim || this->Edited.Around(a).size() <= 3 ||
      this->Edited.Around(b).size() <= 3 || n1.dot(n) < minimum * n1.norm() ||
      n2.dot(n) < minimum * n2.norm())
    {
      return;
    }
    this->Edited.Flip(t, s, a, b);
  }

  /// Returns the centroid of the triangles around v, projected onto its tangent plane.
  Eigen::Vector3d Slid(int v) const
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
    double weight = 0.0;
    for (const int t : this->Edited.Around(v))
    {
      const Triangle& c = this->Edited.Corners(t);
      const Eigen::Vector3d n = this->Edited.AreaVector(c);
      sum += n.norm() *
        (this->Edited.Position(c[0]) + this->Edited.Position(c[1]) + this->Edited.Position(c[2])) /
        3.0;
      weight += n.norm();
      normal += n;
    }
    if (!(weight > 0.0) || !(normal.norm() > 0.0))
    {
      return this->Edited.Position(v);
    }
    normal.normalize();
    const Eigen::Vector3d way = sum / weight - this->Edited.Position(v);
    return this->Edited.Position(v) + way - normal * normal.dot(way);
  }

  SurfaceLocator Original;
  double Length;
  EditableSurface Edited;
  std::unordered_set<long long> Creases;
  std::vector<int> CreaseEdges; ///< how many of them a point has
};

} // namespace

Mesh RemeshIsotropically(
  const Surface& surface, const IsotropicRemeshOptions& options, const Progress& progress)
{
  RequireOption(std::isfinite(options.EdgeLength) && options.EdgeLength > 0.0, "the edge length",
    options.EdgeLength, "positive and finite");
  RequireOption(options.Rounds >= 1, "Rounds", options.Rounds, "at least 1");
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
