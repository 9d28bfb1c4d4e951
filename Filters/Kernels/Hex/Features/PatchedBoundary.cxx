#include "Hex/Features/PatchedBoundary.h"

#include "Hex/Features/Private/CurveResampling.h"
#include "Hex/Features/Private/QuadPatches.h"
#include "Hex/Features/Private/UnmatchedCurves.h"
#include "Mesh/QuadSurface.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
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

/// The patches around each corner of a surface.
std::vector<std::set<int>> PatchesAroundCorners(
  const Surface& surface, const SurfaceFeatures& features)
{
  std::vector<int> cornerOf(surface.Points().rows(), -1);
  for (std::size_t i = 0; i < features.Corners.size(); ++i)
  {
    cornerOf[features.Corners[i]] = static_cast<int>(i);
  }
  std::vector<std::set<int>> around(features.Corners.size());
  for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
  {
    for (const int point : surface.Triangles().row(t))
    {
      if (cornerOf[point] >= 0)
      {
        around[cornerOf[point]].insert(features.PatchOf(t));
      }
    }
  }
  return around;
}

/// Returns the patches of a surface. A single patch is the surface itself, so that its search tree
/// is reused.
std::vector<Surface> PatchesOf(const Surface& surface, const SurfaceFeatures& features)
{
  if (features.Patches == 1)
  {
    return { surface };
  }
  std::vector<Mesh> patches = SplitIntoPatches(surface, features);
  return { std::make_move_iterator(patches.begin()), std::make_move_iterator(patches.end()) };
}

/// A chain of edges between two patches of the quads.
struct Chain
{
  std::vector<int> Points;
  std::array<int, 2> Patches;
  std::array<int, 2> Corners; ///< its end corners, ascending; -1 if it is closed
};

using IndexPair = std::pair<int, int>;

/// Chooses pairs from the candidates, in ascending order of their distances. No two chosen pairs
/// have the same first index or the same second index.
std::vector<IndexPair> PairNearestFirst(std::vector<std::pair<double, IndexPair>> candidates)
{
  std::sort(candidates.begin(), candidates.end());
  std::set<int> firstTaken, secondTaken;
  std::vector<IndexPair> pairs;
  for (const auto& [distance, pair] : candidates)
  {
    if (firstTaken.count(pair.first) == 0 && secondTaken.count(pair.second) == 0)
    {
      firstTaken.insert(pair.first);
      secondTaken.insert(pair.second);
      pairs.push_back(pair);
    }
  }
  return pairs;
}

/// Pairs corners with points of the quads between the same patches, the nearest first. Returns the
/// corner of each point, or -1; nothing unless every corner, and every point where three or more
/// patches meet, is in a pair.
std::optional<std::vector<int>> MatchCorners(const Eigen::MatrixXd& points, const Surface& surface,
  const SurfaceFeatures& features, const PatchedBoundary& boundary, UnmatchedCurves& unmatched)
{
  const auto corners = PatchesAroundCorners(surface, features);
  const auto around = PatchesAround(boundary, points.rows());
  std::vector<std::pair<double, IndexPair>> candidates;
  std::set<int> junctions;
  for (int point = 0; point < static_cast<int>(around.size()); ++point)
  {
    if (around[point].size() < 3)
    {
      continue;
    }
    junctions.insert(point);
    for (int corner = 0; corner < static_cast<int>(corners.size()); ++corner)
    {
      if (corners[corner] == around[point])
      {
        candidates.push_back(
          { (points.row(point) - surface.Points().row(features.Corners[corner])).norm(),
            { point, corner } });
      }
    }
  }
  const std::vector<IndexPair> pairs = PairNearestFirst(std::move(candidates));
  std::vector<int> cornerOf(around.size(), -1);
  std::vector<char> isPaired(corners.size(), 0);
  for (const auto& [point, corner] : pairs)
  {
    cornerOf[point] = corner;
    isPaired[corner] = 1;
    junctions.erase(point);
  }
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
  {
    if (!isPaired[corner])
    {
      unmatched.AddAtCorner(features.Corners[corner]);
    }
  }
  if (pairs.size() < corners.size())
  {
    return std::nullopt; // points without a corner may be what these corners became
  }
  for (const int point : junctions)
  {
    unmatched.AddBetween(around[point], points.row(point));
  }
  return junctions.empty() ? std::optional(std::move(cornerOf)) : std::nullopt;
}

/// Finds the chains between the patches of the quads: first those that end at corners, then closed
/// ones. cornerOf: the corner of each point, or -1.
std::vector<Chain> FindChains(const PatchedBoundary& boundary, const std::vector<int>& cornerOf)
{
  const QuadSurface quads(boundary.Quads);
  const auto patchAt = [&](int a, int b) { return boundary.PatchOf(quads.QuadAt({ a, b })); };
  std::map<int, std::vector<int>> neighbours; // along edges between two patches
  for (const auto& [edge, quad] : quads.Edges())
  {
    if (patchAt(edge.second, edge.first) != boundary.PatchOf(quad))
    {
      neighbours[edge.first].push_back(edge.second);
    }
  }
  std::set<QuadEdge> taken;
  const auto isCorner = [&](int point) { return cornerOf[point] >= 0; };
  const auto follow = [&](int first, int second)
  {
    const int a = patchAt(first, second), b = patchAt(second, first);
    Chain chain{ { first }, { std::min(a, b), std::max(a, b) }, { -1, -1 } };
    for (int before = first, point = second;;)
    {
      taken.insert({ before, point });
      taken.insert({ point, before });
      if (point == first && !isCorner(point))
      {
        return chain;
      }
      chain.Points.push_back(point);
      if (isCorner(point))
      {
        chain.Corners = { cornerOf[first], cornerOf[point] };
        std::sort(chain.Corners.begin(), chain.Corners.end());
        return chain;
      }
      const std::vector<int>& next = neighbours.at(point);
      const int after = next[0] == before ? next[1] : next[0];
      before = point;
      point = after;
    }
  };
  std::vector<Chain> chains;
  for (const bool corners : { true, false })
  {
    for (const auto& [point, next] : neighbours)
    {
      for (const int end : next)
      {
        if (isCorner(point) == corners && taken.count({ point, end }) == 0)
        {
          chains.push_back(follow(point, end));
        }
      }
    }
  }
  return chains;
}

/// Returns the mean distance of the chain's points from a curve.
double MeasureDistance(const Eigen::MatrixXd& points, const Chain& chain, const Surface& surface,
  const FeatureCurve& curve)
{
  double sum = 0.0;
  for (const int point : chain.Points)
  {
    sum += (surface.Points()(curve.Points, Eigen::all).rowwise() - points.row(point))
             .rowwise()
             .norm()
             .minCoeff();
  }
  return sum / static_cast<double>(chain.Points.size());
}

/// Pairs chains with curves between the same patches and corners, the nearest first. Returns the
/// chain and the curve of each pair; nothing unless every chain and every curve is in a pair.
std::optional<std::vector<IndexPair>> PairChainsWithCurves(const Eigen::MatrixXd& points,
  const std::vector<Chain>& chains, const Surface& surface, const SurfaceFeatures& features,
  UnmatchedCurves& unmatched)
{
  std::map<int, int> cornerOf;
  for (std::size_t i = 0; i < features.Corners.size(); ++i)
  {
    cornerOf[features.Corners[i]] = static_cast<int>(i);
  }
  std::vector<std::pair<double, IndexPair>> candidates;
  for (int j = 0; j < static_cast<int>(features.Curves.size()); ++j)
  {
    const FeatureCurve& curve = features.Curves[j];
    std::array<int, 2> ends = { -1, -1 };
    if (!curve.Closed)
    {
      ends = { cornerOf.at(curve.Points.front()), cornerOf.at(curve.Points.back()) };
      std::sort(ends.begin(), ends.end());
    }
    for (int i = 0; i < static_cast<int>(chains.size()); ++i)
    {
      if (chains[i].Patches == curve.Patches && chains[i].Corners == ends)
      {
        candidates.push_back({ MeasureDistance(points, chains[i], surface, curve), { i, j } });
      }
    }
  }
  std::vector<IndexPair> pairs = PairNearestFirst(std::move(candidates));
  std::set<int> freeChains, freeCurves;
  for (int i = 0; i < static_cast<int>(chains.size()); ++i)
  {
    freeChains.insert(freeChains.end(), i);
  }
  for (int j = 0; j < static_cast<int>(features.Curves.size()); ++j)
  {
    freeCurves.insert(freeCurves.end(), j);
  }
  for (const auto& [chain, curve] : pairs)
  {
    freeChains.erase(chain);
    freeCurves.erase(curve);
  }
  for (const int curve : freeCurves)
  {
    unmatched.Add(curve);
  }
  for (const int chain : freeChains)
  {
    const std::array<int, 2>& patches = chains[chain].Patches;
    unmatched.AddBetween(
      { patches.begin(), patches.end() }, points.row(chains[chain].Points.front()));
  }
  return freeChains.empty() && freeCurves.empty() ? std::optional(std::move(pairs)) : std::nullopt;
}

/// Distributes the points of a chain along its curve; a corner's point goes to the corner.
void PutOnCurve(const Eigen::MatrixXd& points, const Chain& chain, const Surface& surface,
  const SurfaceFeatures& features, int id, PatchedBoundary& boundary)
{
  const CurvePositions positions = DistributeAlongCurve(points(chain.Points, Eigen::all), surface,
    features.Curves[id], ComputeCreaseTolerance(surface));
  for (std::size_t i = 0; i < chain.Points.size(); ++i)
  {
    const int point = chain.Points[i];
    const int corner = boundary.CornerOf[point];
    if (corner < 0)
    {
      boundary.CurveOf[point] = id;
      boundary.Starts.emplace_back(point, positions.Positions.row(static_cast<Eigen::Index>(i)));
      boundary.Spans[point] = positions.Spans[i];
    }
    else
    {
      boundary.Starts.emplace_back(point, surface.Points().row(features.Corners[corner]));
    }
  }
}

} // namespace

std::optional<PatchedBoundary> MatchFeatures(const HexMesh& mesh, const Surface& surface,
  const SurfaceFeatures& features, std::set<int>& unmatched)
{
  PatchedBoundary boundary;
  boundary.Quads = FindBoundaryQuads(mesh);
  boundary.Patches = PatchesOf(surface, features);
  boundary.PatchOf = AssignQuadsToPatches(
    mesh.Points, QuadSurface(boundary.Quads), surface, features, boundary.Patches);
  const std::set<int> present(boundary.PatchOf.begin(), boundary.PatchOf.end());
  if (present.empty())
  {
    return std::nullopt; // a component of the boundary has no patch
  }
  UnmatchedCurves curves(surface, features);
  for (int patch = 0; patch < features.Patches; ++patch)
  {
    if (present.count(patch) == 0)
    {
      curves.AddAround(patch);
    }
  }
  unmatched = curves.Indices();
  if (static_cast<int>(present.size()) < features.Patches ||
    !MatchCurves(mesh, surface, features, boundary, unmatched))
  {
    return std::nullopt;
  }
  return boundary;
}

bool MatchCurves(const HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features,
  PatchedBoundary& boundary, std::set<int>& unmatched)
{
  UnmatchedCurves curves(surface, features);
  const auto cornerOf = MatchCorners(mesh.Points, surface, features, boundary, curves);
  if (!cornerOf)
  {
    unmatched = curves.Indices();
    return false;
  }
  const std::vector<Chain> chains = FindChains(boundary, *cornerOf);
  const auto pairs = PairChainsWithCurves(mesh.Points, chains, surface, features, curves);
  unmatched = curves.Indices();
  if (!pairs)
  {
    return false;
  }
  boundary.CornerOf = *cornerOf;
  boundary.CurveOf.assign(mesh.Points.rows(), -1);
  boundary.Starts.clear();
  boundary.Spans.clear();
  for (const auto& [chain, curve] : *pairs)
  {
    PutOnCurve(mesh.Points, chains[chain], surface, features, curve, boundary);
  }
  return true;
}

} // namespace shape
