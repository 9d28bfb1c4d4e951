#include "Hex/Features/Private/CornerValenceMatching.h"

#include "Hex/Features/PatchRings.h"
#include "Hex/Features/Private/DisjointPaths.h"

#include <algorithm>
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

/// Quads with positions, and the quads at each point.
struct PlacedQuads
{
  PlacedQuads(const Eigen::MatrixXd& points, const QuadSurface& quads)
    : Points(points)
    , Quads(quads)
    , QuadsAt(points.rows())
  {
    for (int q = 0; q < static_cast<int>(quads.Quads().rows()); ++q)
    {
      for (const int point : quads.Quads().row(q))
      {
        this->QuadsAt[point].push_back(q);
      }
    }
  }

  Eigen::RowVector4i PointsOf(int quad) const { return this->Quads.Quads().row(quad); }

  const Eigen::MatrixXd& Points; ///< n x 3
  const QuadSurface& Quads;
  std::vector<std::vector<int>> QuadsAt; ///< of each point
};

/// Returns the points of the quads, those closest to a position first.
std::vector<int> FindNearestPoints(const PlacedQuads& quads, const Eigen::RowVector3d& position)
{
  std::vector<std::pair<double, int>> order;
  for (int point = 0; point < static_cast<int>(quads.QuadsAt.size()); ++point)
  {
    if (!quads.QuadsAt[point].empty())
    {
      order.emplace_back((quads.Points.row(point) - position).norm(), point);
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

/// Returns the patches around a point of the quads.
PatchRing FindRing(const PlacedQuads& quads, const Eigen::VectorXi& patchOf, int point)
{
  std::vector<int> labels;
  for (const int quad : quads.Quads.QuadsAround(point, quads.QuadsAt[point].front()))
  {
    labels.push_back(patchOf(quad));
  }
  return BuildPatchRing(labels);
}

/// Adds to a disk the quads that share a point with it.
void GrowDisc(const PlacedQuads& quads, std::set<int>& disc)
{
  const std::set<int> before = disc;
  for (const int quad : before)
  {
    for (const int point : quads.PointsOf(quad))
    {
      disc.insert(quads.QuadsAt[point].begin(), quads.QuadsAt[point].end());
    }
  }
}

/// Returns the boundary loop of a disk, counter-clockwise; empty if it is not one simple closed
/// chain, or if a point of the disk belongs to a corner already.
std::vector<int> FindDiscLoop(
  const PlacedQuads& quads, const std::set<int>& disc, const std::vector<char>& isCorner)
{
  std::map<int, int> next;
  std::size_t edges = 0;
  for (const int quad : disc)
  {
    const Eigen::RowVector4i points = quads.PointsOf(quad);
    for (int k = 0; k < 4; ++k)
    {
      const int a = points(k), b = points((k + 1) % 4);
      if (isCorner[a])
      {
        return {};
      }
      if (disc.count(quads.Quads.QuadAt({ b, a })) == 0)
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
/// patches outside are not those of the ring, each once.
std::optional<std::vector<int>> FindChainEnds(const PlacedQuads& quads,
  const Eigen::VectorXi& patchOf, const std::vector<int>& loop, const PatchRing& ring)
{
  std::vector<int> ends, labels;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const int before = loop[(i + loop.size() - 1) % loop.size()], point = loop[i];
    const int after = loop[(i + 1) % loop.size()];
    const int last = quads.Quads.QuadAt({ after, point });
    int quad = quads.Quads.QuadAt({ point, before }), changes = 0;
    labels.push_back(patchOf(quad));
    while (quad != last)
    {
      const int following = quads.Quads.NextAround(point, quad);
      changes += patchOf(following) != patchOf(quad);
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
  return BuildPatchRing(labels) == ring && ends.size() == ring.size() ? std::optional(ends)
                                                                      : std::nullopt;
}

/// Returns the distance of a position from the nearest curve.
double ComputeDistanceToCurves(
  const Eigen::RowVector3d& position, const Mesh& surface, const SurfaceFeatures& features)
{
  double minimum = std::numeric_limits<double>::infinity();
  for (const FeatureCurve& curve : features.Curves)
  {
    const std::size_t count = curve.Points.size();
    for (std::size_t i = 0; i + (curve.Closed ? 0 : 1) < count; ++i)
    {
      const Eigen::RowVector3d a = surface.Points.row(curve.Points[i]);
      const Eigen::RowVector3d along = surface.Points.row(curve.Points[(i + 1) % count]) - a;
      const Eigen::RowVector3d from = position - a;
      const double share =
        std::clamp(from.dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
      minimum = std::min(minimum, (from - share * along).norm());
    }
  }
  return minimum;
}

/// Finds a chain of edges of the disk from a point to each of the ends. The chains share no other
/// point and are as short and as close to the curves as possible. Returns their edges in both
/// directions; nothing if there are no such chains.
std::optional<std::set<QuadEdge>> FindGatheringChains(const PlacedQuads& quads,
  const std::set<int>& disc, const std::vector<int>& loop, const std::vector<int>& ends, int point,
  const Mesh& surface, const SurfaceFeatures& features)
{
  CostGraph graph;
  std::map<int, int> nodeOf;
  std::vector<int> points; // of the nodes
  for (const int quad : disc)
  {
    for (const int own : quads.PointsOf(quad))
    {
      if (nodeOf.emplace(own, static_cast<int>(points.size())).second)
      {
        points.push_back(own);
        graph.NodeCosts.push_back(
          ComputeDistanceToCurves(quads.Points.row(own), surface, features));
      }
    }
  }
  const std::set<int> onLoop(loop.begin(), loop.end());
  for (const int quad : disc)
  {
    const Eigen::RowVector4i own = quads.PointsOf(quad);
    for (int k = 0; k < 4; ++k)
    {
      const int a = own(k), b = own((k + 1) % 4);
      if (a < b && disc.count(quads.Quads.QuadAt({ b, a })) > 0 &&
        (onLoop.count(a) == 0 || onLoop.count(b) == 0))
      {
        graph.EdgeCosts[{ nodeOf.at(a), nodeOf.at(b) }] =
          (quads.Points.row(a) - quads.Points.row(b)).norm();
      }
    }
  }
  std::vector<int> endNodes;
  std::transform(ends.begin(), ends.end(), std::back_inserter(endNodes),
    [&](int end) { return nodeOf.at(end); });
  const auto steps = FindDisjointPaths(graph, nodeOf.at(point), endNodes);
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

/// Extends the patches outside the disk's loop into the disk, up to the chains.
void FillDisc(const PlacedQuads& quads, const std::set<int>& disc, const std::set<QuadEdge>& chains,
  Eigen::VectorXi& patchOf)
{
  std::map<int, int> label;
  std::vector<int> open;
  for (const int quad : disc)
  {
    for (int k = 0; k < 4; ++k)
    {
      const int beyond = quads.Quads.Across(quad, k);
      if (disc.count(beyond) == 0 && label.emplace(quad, patchOf(beyond)).second)
      {
        open.push_back(quad);
      }
    }
  }
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    const Eigen::RowVector4i points = quads.PointsOf(open[i]);
    for (int k = 0; k < 4; ++k)
    {
      const int beyond = quads.Quads.Across(open[i], k);
      if (disc.count(beyond) > 0 && chains.count({ points(k), points((k + 1) % 4) }) == 0 &&
        label.emplace(beyond, label.at(open[i])).second)
      {
        open.push_back(beyond);
      }
    }
  }
  for (const auto& [quad, patch] : label)
  {
    patchOf(quad) = patch;
  }
}

/// Routes chains from a point to the loop of a disk around it and assigns the quads between them.
/// Returns false if the patches outside the disk are not those of the ring, or if there are no such
/// chains.
bool GatherInDisc(const PlacedQuads& quads, const std::set<int>& disc, int point,
  const PatchRing& ring, const Mesh& surface, const SurfaceFeatures& features,
  const std::vector<char>& isCorner, Eigen::VectorXi& patchOf)
{
  const std::vector<int> loop = FindDiscLoop(quads, disc, isCorner);
  if (loop.empty())
  {
    return false;
  }
  const auto ends = FindChainEnds(quads, patchOf, loop, ring);
  if (!ends)
  {
    return false;
  }
  const auto chains = FindGatheringChains(quads, disc, loop, *ends, point, surface, features);
  if (!chains)
  {
    return false;
  }
  FillDisc(quads, disc, *chains, patchOf);
  return true;
}

/// Gathers the patches of a corner around one of the points nearest to it. Returns the point, or
/// -1 if no disk around any of them is suitable.
int GatherPatches(const PlacedQuads& quads, int corner, const PatchRing& ring, const Mesh& surface,
  const SurfaceFeatures& features, const std::vector<char>& isCorner, Eigen::VectorXi& patchOf)
{
  constexpr int tries = 40, largest = 6; // points, rings of quads
  int tried = 0;
  for (const int point : FindNearestPoints(quads, surface.Points.row(features.Corners[corner])))
  {
    const std::vector<int>& around = quads.QuadsAt[point];
    if (around.size() < ring.size() || isCorner[point])
    {
      continue;
    }
    std::set<int> disc(around.begin(), around.end());
    for (int radius = 1; radius <= largest; ++radius)
    {
      GrowDisc(quads, disc);
      if (GatherInDisc(quads, disc, point, ring, surface, features, isCorner, patchOf))
      {
        return point;
      }
    }
    if (++tried == tries)
    {
      break;
    }
  }
  return -1;
}

} // namespace

void MatchCornerValences(const Eigen::MatrixXd& points, const QuadSurface& quads,
  const Mesh& surface, const SurfaceFeatures& features, Eigen::VectorXi& patchOf)
{
  const PlacedQuads placed(points, quads);
  const std::vector<PatchRing> rings = FindCornerRings(surface, features);
  std::vector<char> isCorner(points.rows(), 0);
  // First the corners that already have a point with their ring: no disk may reach these points.
  std::vector<int> missing;
  for (int corner = 0; corner < static_cast<int>(rings.size()); ++corner)
  {
    const std::vector<int> nearest =
      FindNearestPoints(placed, surface.Points.row(features.Corners[corner]));
    const auto found = std::find_if(nearest.begin(), nearest.end(),
      [&](int point)
      { return !isCorner[point] && FindRing(placed, patchOf, point) == rings[corner]; });
    if (found != nearest.end())
    {
      isCorner[*found] = 1;
    }
    else
    {
      missing.push_back(corner);
    }
  }
  for (const int corner : missing)
  {
    if (const int point =
          GatherPatches(placed, corner, rings[corner], surface, features, isCorner, patchOf);
        point >= 0)
    {
      isCorner[point] = 1;
    }
  }
}

} // namespace shape
