#include "Hex/PatchedBoundary.h"

#include "Hex/Padding.h"
#include "Hex/QuadPatches.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace shape
{
namespace
{

/// The patches around each point of a boundary.
std::vector<std::set<int>> PatchesAround(const PatchedBoundary& boundary, std::size_t points)
{
  std::vector<std::set<int>> around(points);
  for (Eigen::Index q = 0; q < boundary.Quads.rows(); ++q)
  {
    for (const int point : boundary.Quads.row(q))
    {
      around[point].insert(boundary.PatchOf(q));
    }
  }
  return around;
}

/// The quad's edges, each from its corner k to the next one, beyond which another patch lies.
using Edge = std::pair<int, int>;
std::map<Edge, int> PatchesOfEdges(const PatchedBoundary& boundary)
{
  std::map<Edge, int> patches;
  for (Eigen::Index q = 0; q < boundary.Quads.rows(); ++q)
  {
    for (int k = 0; k < 4; ++k)
    {
      patches[{ boundary.Quads(q, k), boundary.Quads(q, (k + 1) % 4) }] = boundary.PatchOf(q);
    }
  }
  return patches;
}

/// The patches around each corner of a surface.
std::vector<std::set<int>> PatchesAroundCorners(
  const Mesh& surface, const SurfaceFeatures& features)
{
  std::vector<int> cornerOf(surface.Points.rows(), -1);
  for (std::size_t i = 0; i < features.Corners.size(); ++i)
  {
    cornerOf[features.Corners[i]] = static_cast<int>(i);
  }
  std::vector<std::set<int>> around(features.Corners.size());
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    for (const int point : surface.Triangles.row(t))
    {
      if (cornerOf[point] >= 0)
      {
        around[cornerOf[point]].insert(features.PatchOf(t));
      }
    }
  }
  return around;
}

/// A chain of edges between two patches of the quads.
struct Chain
{
  std::vector<int> Points;
  std::array<int, 2> Patches;
  std::array<int, 2> Corners; ///< at its ends, ascending; -1 where it is closed
};

/// A polyline by the length along it.
class ArcLength
{
public:
  ArcLength(const Mesh& surface, const FeatureCurve& curve)
    : Points(surface.Points(curve.Points, Eigen::all))
    , Closed(curve.Closed)
  {
    const Eigen::Index count = this->Points.rows();
    this->Lengths = { 0.0 };
    for (Eigen::Index i = 1; i < count + (this->Closed ? 1 : 0); ++i)
    {
      this->Lengths.push_back(
        this->Lengths.back() + (this->Points.row(i % count) - this->Points.row(i - 1)).norm());
    }
  }

  double Length() const { return this->Lengths.back(); }

  /// The length to its point closest to a place.
  double Nearest(const Eigen::RowVector3d& place) const
  {
    Eigen::Index nearest = 0;
    (this->Points.rowwise() - place).rowwise().squaredNorm().minCoeff(&nearest);
    return this->Lengths[nearest];
  }

  Eigen::RowVector3d At(double length) const
  {
    length = this->Closed ? length - this->Length() * std::floor(length / this->Length())
                          : std::clamp(length, 0.0, this->Length());
    const auto next = std::clamp<std::ptrdiff_t>(
      std::upper_bound(this->Lengths.begin(), this->Lengths.end(), length) - this->Lengths.begin(),
      1, static_cast<std::ptrdiff_t>(this->Lengths.size()) - 1);
    const double step = this->Lengths[next] - this->Lengths[next - 1];
    const double share = step > 0.0 ? (length - this->Lengths[next - 1]) / step : 0.0;
    return (1.0 - share) * this->Points.row(next - 1) +
      share * this->Points.row(next % this->Points.rows());
  }

private:
  Eigen::MatrixXd Points;
  bool Closed;
  std::vector<double> Lengths; ///< to each point; of a closed one, to the first again, too
};

/// The points of a chain (n x 3) spread along a curve as they are along the chain, in the direction
/// that brings them closer.
Eigen::MatrixXd SpreadAlong(const Eigen::MatrixXd& chain, const ArcLength& curve, bool closed)
{
  const Eigen::Index count = chain.rows();
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 1; i < count; ++i)
  {
    lengths(i) = lengths(i - 1) + (chain.row(i) - chain.row(i - 1)).norm();
  }
  const double whole =
    lengths(count - 1) + (closed ? (chain.row(0) - chain.row(count - 1)).norm() : 0.0);
  const double first = closed ? curve.Nearest(chain.row(0)) : 0.0;
  Eigen::MatrixXd best;
  double least = std::numeric_limits<double>::infinity();
  for (const double direction : { 1.0, -1.0 })
  {
    Eigen::MatrixXd places(count, 3);
    const double begin = closed || direction > 0.0 ? first : curve.Length();
    for (Eigen::Index i = 0; i < count; ++i)
    {
      places.row(i) = curve.At(begin + direction * curve.Length() * lengths(i) / whole);
    }
    if (const double sum = (places - chain).rowwise().norm().sum(); sum < least)
    {
      least = sum;
      best = std::move(places);
    }
  }
  return best;
}

class Matcher
{
public:
  Matcher(const HexMesh& mesh, const Mesh& surface, const SurfaceFeatures& features,
    PatchedBoundary& boundary)
    : Points(mesh.Points)
    , Surface(surface)
    , Features(features)
    , Boundary(boundary)
    , Around(PatchesAround(boundary, mesh.Points.rows()))
  {
    boundary.CurveOf.assign(mesh.Points.rows(), -1);
    boundary.CornerOf.assign(mesh.Points.rows(), -1);
  }

  bool Run() { return this->MatchCorners() && this->FindChains() && this->MatchCurves(); }

private:
  /// Corners and points of the quads have to be as many between the same patches; nearest first.
  bool MatchCorners()
  {
    const auto corners = PatchesAroundCorners(this->Surface, this->Features);
    std::vector<std::pair<double, std::pair<int, int>>> pairs;
    std::size_t junctions = 0;
    for (int point = 0; point < static_cast<int>(this->Around.size()); ++point)
    {
      if (this->Around[point].size() < 3)
      {
        continue;
      }
      ++junctions;
      for (int corner = 0; corner < static_cast<int>(corners.size()); ++corner)
      {
        if (corners[corner] == this->Around[point])
        {
          const double distance =
            (this->Points.row(point) - this->Surface.Points.row(this->Features.Corners[corner]))
              .norm();
          pairs.push_back({ distance, { point, corner } });
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<char> taken(corners.size(), 0);
    std::size_t matched = 0;
    for (const auto& [distance, pair] : pairs)
    {
      if (this->Boundary.CornerOf[pair.first] < 0 && !taken[pair.second])
      {
        this->Boundary.CornerOf[pair.first] = pair.second;
        taken[pair.second] = 1;
        ++matched;
      }
    }
    return matched == corners.size() && matched == junctions;
  }

  bool FindChains()
  {
    const std::map<Edge, int> patches = PatchesOfEdges(this->Boundary);
    std::map<int, std::vector<int>> neighbours;
    for (const auto& [edge, patch] : patches)
    {
      const auto other = patches.find({ edge.second, edge.first });
      if (other->second != patch)
      {
        neighbours[edge.first].push_back(edge.second);
      }
    }
    std::set<Edge> taken;
    const auto isCorner = [&](int point) { return this->Boundary.CornerOf[point] >= 0; };
    const auto follow = [&](int first, int second)
    {
      if (taken.count({ first, second }) > 0)
      {
        return;
      }
      const int a = patches.at({ first, second }), b = patches.at({ second, first });
      Chain chain{ { first }, { std::min(a, b), std::max(a, b) }, { -1, -1 } };
      for (int before = first, point = second;;)
      {
        taken.insert({ before, point });
        taken.insert({ point, before });
        if (point == first && !isCorner(point))
        {
          break;
        }
        chain.Points.push_back(point);
        if (isCorner(point))
        {
          chain.Corners = { this->Boundary.CornerOf[first], this->Boundary.CornerOf[point] };
          std::sort(chain.Corners.begin(), chain.Corners.end());
          break;
        }
        const std::vector<int>& next = neighbours.at(point);
        const int after = next[0] == before ? next[1] : next[0];
        before = point;
        point = after;
      }
      this->Chains.push_back(std::move(chain));
    };
    for (const auto& [point, next] : neighbours)
    {
      if (!isCorner(point) && next.size() != 2)
      {
      }
    }
    for (const bool corners : { true, false })
    {
      for (const auto& [point, next] : neighbours)
      {
        if (isCorner(point) == corners)
        {
          for (const int end : next)
          {
            follow(point, end);
          }
        }
      }
    }
    return true;
  }

  /// How far the chain's points lie from a curve's, on average.
  double Distance(const Chain& chain, const FeatureCurve& curve) const
  {
    double sum = 0.0;
    for (const int point : chain.Points)
    {
      sum += (this->Surface.Points(curve.Points, Eigen::all).rowwise() - this->Points.row(point))
               .rowwise()
               .norm()
               .minCoeff();
    }
    return sum / static_cast<double>(chain.Points.size());
  }

  void PutOnCurve(const Chain& chain, int id)
  {
    const FeatureCurve& curve = this->Features.Curves[id];
    const Eigen::MatrixXd places = SpreadAlong(
      this->Points(chain.Points, Eigen::all), ArcLength(this->Surface, curve), curve.Closed);
    for (std::size_t i = 0; i < chain.Points.size(); ++i)
    {
      const int point = chain.Points[i];
      if (this->Boundary.CornerOf[point] < 0)
      {
        this->Boundary.CurveOf[point] = id;
      }
      this->Boundary.Starts.emplace_back(point, places.row(static_cast<Eigen::Index>(i)));
    }
  }

  bool MatchCurves()
  {
    this->Boundary.Starts.clear();
    if (this->Chains.size() != this->Features.Curves.size())
    {
      return false;
    }
    std::map<int, int> cornerOf;
    for (std::size_t i = 0; i < this->Features.Corners.size(); ++i)
    {
      cornerOf[this->Features.Corners[i]] = static_cast<int>(i);
    }
    std::vector<std::pair<double, std::pair<int, int>>> pairs;
    for (int j = 0; j < static_cast<int>(this->Features.Curves.size()); ++j)
    {
      const FeatureCurve& curve = this->Features.Curves[j];
      std::array<int, 2> ends = { -1, -1 };
      if (!curve.Closed)
      {
        ends = { cornerOf.at(curve.Points.front()), cornerOf.at(curve.Points.back()) };
        std::sort(ends.begin(), ends.end());
      }
      for (int i = 0; i < static_cast<int>(this->Chains.size()); ++i)
      {
        if (this->Chains[i].Patches == curve.Patches && this->Chains[i].Corners == ends)
        {
          pairs.push_back({ this->Distance(this->Chains[i], curve), { i, j } });
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<char> chainTaken(this->Chains.size(), 0), curveTaken(this->Chains.size(), 0);
    std::size_t matched = 0;
    for (const auto& [distance, pair] : pairs)
    {
      if (!chainTaken[pair.first] && !curveTaken[pair.second])
      {
        chainTaken[pair.first] = curveTaken[pair.second] = 1;
        ++matched;
        this->PutOnCurve(this->Chains[pair.first], pair.second);
      }
    }
    return matched == this->Chains.size();
  }

  const Eigen::MatrixXd& Points;
  const Mesh& Surface;
  const SurfaceFeatures& Features;
  PatchedBoundary& Boundary;
  const std::vector<std::set<int>> Around;
  std::vector<Chain> Chains;
};

} // namespace

std::optional<PatchedBoundary> MatchFeatures(
  const HexMesh& mesh, const SurfaceLocator& surface, const SurfaceFeatures& features)
{
  PatchedBoundary boundary;
  boundary.Quads = BoundaryQuads(mesh);
  boundary.PatchOf = QuadPatches(mesh.Points, boundary.Quads, surface, features);
  if (boundary.PatchOf.size() == 0 || !Matcher(mesh, surface.Surface(), features, boundary).Run())
  {
    return std::nullopt;
  }
  return boundary;
}

bool MatchCurves(const HexMesh& mesh, const Mesh& surface, const SurfaceFeatures& features,
  PatchedBoundary& boundary)
{
  return Matcher(mesh, surface, features, boundary).Run();
}

std::vector<int> PatchesBesideStraightCorners(
  const PatchedBoundary& boundary, const std::vector<int>& groups)
{
  const std::map<Edge, int> patches = PatchesOfEdges(boundary);
  std::set<int> beside;
  for (Eigen::Index q = 0; q < boundary.Quads.rows(); ++q)
  {
    std::array<int, 4> beyond{};
    for (int k = 0; k < 4; ++k)
    {
      beyond[k] = patches.at({ boundary.Quads(q, (k + 1) % 4), boundary.Quads(q, k) });
    }
    for (int k = 0; k < 4; ++k)
    {
      const int next = (k + 1) % 4;
      if (boundary.CornerOf[boundary.Quads(q, next)] < 0 && beyond[k] == beyond[next] &&
        beyond[k] != boundary.PatchOf(q) && groups[beyond[k]] == groups[boundary.PatchOf(q)])
      {
        beside.insert(beyond[k]);
      }
    }
  }
  return { beside.begin(), beside.end() };
}

std::vector<int> LayerGroups(const Mesh& surface, const SurfaceFeatures& features)
{
  constexpr double wide = 135.0;               // degrees
  std::map<int, std::map<int, double>> angles; // of each corner, of each patch there
  for (const int corner : features.Corners)
  {
    angles[corner];
  }
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto corner = angles.find(surface.Triangles(t, k));
      if (corner != angles.end())
      {
        const Eigen::Matrix3d corners = Corners(surface, t);
        const Eigen::RowVector3d a = corners.row((k + 1) % 3) - corners.row(k);
        const Eigen::RowVector3d b = corners.row((k + 2) % 3) - corners.row(k);
        corner->second[features.PatchOf(t)] += std::atan2(a.cross(b).norm(), a.dot(b));
      }
    }
  }
  std::vector<int> groups(features.Patches);
  std::iota(groups.begin(), groups.end(), 0);
  const auto unite = [&](int one, int other)
  { std::replace(groups.begin(), groups.end(), int(groups[one]), int(groups[other])); };
  for (const FeatureCurve& curve : features.Curves)
  {
    if (curve.Angle > wide)
    {
      unite(curve.Patches[0], curve.Patches[1]);
    }
  }
  for (const auto& [corner, patches] : angles)
  {
    for (const auto& [patch, angle] : patches)
    {
      if (angle * 180.0 / M_PI < wide)
      {
        continue;
      }
      int first = -1;
      for (const auto& [other, unused] : patches)
      {
        if (other != patch)
        {
          first = first < 0 ? other : first;
          unite(other, first);
        }
      }
    }
  }
  return groups;
}

namespace
{

void RememberCopies(const std::vector<int>& copyOf, PatchedBoundary& boundary)
{
  for (int point = 0; point < static_cast<int>(copyOf.size()); ++point)
  {
    if (copyOf[point] >= 0)
    {
      boundary.Copies.emplace_back(point, copyOf[point]);
    }
  }
}

} // namespace

void PadPatches(HexMesh& mesh, const std::vector<int>& patches, PatchedBoundary& boundary)
{
  const std::map<Edge, int> patchOfEdge = PatchesOfEdges(boundary);
  const auto isPadded = [&](int patch)
  { return std::find(patches.begin(), patches.end(), patch) != patches.end(); };
  std::vector<int> own;
  for (int q = 0; q < static_cast<int>(boundary.Quads.rows()); ++q)
  {
    if (isPadded(boundary.PatchOf(q)))
    {
      own.push_back(q);
    }
  }
  const Eigen::MatrixXi quads = boundary.Quads(own, Eigen::all);
  const std::vector<int> copyOf = PadQuads(mesh, quads);
  RememberCopies(copyOf, boundary);
  // Beyond the border the copies take the place of the points that they were made of.
  for (Eigen::Index q = 0; q < boundary.Quads.rows(); ++q)
  {
    if (!isPadded(boundary.PatchOf(q)))
    {
      for (int& point : boundary.Quads.row(q))
      {
        point = copyOf[point] >= 0 ? copyOf[point] : point;
      }
    }
  }
  std::vector<std::pair<Eigen::RowVector4i, int>> sides;
  for (const auto& [edge, patch] : patchOfEdge)
  {
    const int beyond = patchOfEdge.at({ edge.second, edge.first });
    if (isPadded(patch) && !isPadded(beyond))
    {
      sides.emplace_back(
        Eigen::RowVector4i(edge.second, edge.first, copyOf[edge.first], copyOf[edge.second]),
        beyond);
    }
  }
  Eigen::Index row = boundary.Quads.rows();
  boundary.Quads.conservativeResize(row + static_cast<Eigen::Index>(sides.size()), 4);
  boundary.PatchOf.conservativeResize(boundary.Quads.rows());
  for (const auto& [quad, patch] : sides)
  {
    boundary.Quads.row(row) = quad;
    boundary.PatchOf(row++) = patch;
  }
}

void PadBoundary(HexMesh& mesh, PatchedBoundary& boundary)
{
  RememberCopies(PadQuads(mesh, boundary.Quads), boundary);
  boundary.CurveOf.resize(mesh.Points.rows(), -1);
  boundary.CornerOf.resize(mesh.Points.rows(), -1);
}

void SpreadLayers(const PatchedBoundary& boundary, Eigen::MatrixXd& points)
{
  std::map<int, std::vector<int>> stacks;
  for (const auto& [point, copy] : boundary.Copies)
  {
    stacks[point].push_back(copy);
  }
  for (const auto& [point, stack] : stacks)
  {
    const Eigen::RowVector3d low = points.row(stack[0]), high = points.row(point);
    for (std::size_t i = 1; i < stack.size(); ++i)
    {
      const double share = static_cast<double>(i) / static_cast<double>(stack.size());
      points.row(stack[i]) = (1.0 - share) * low + share * high;
    }
  }
}

} // namespace shape
