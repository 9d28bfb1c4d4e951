#include "Hex/Features/Private/QuadPatches.h"

#include "Hex/Features/PatchRings.h"
#include "Hex/Features/Private/CornerValenceMatching.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <array>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The quads across the four edges of each quad (q x 4).
Eigen::MatrixXi NeighboursOf(const QuadSurface& surface)
{
  Eigen::MatrixXi neighbours(surface.Quads().rows(), 4);
  for (int q = 0; q < static_cast<int>(neighbours.rows()); ++q)
  {
    for (int k = 0; k < 4; ++k)
    {
      neighbours(q, k) = surface.Across(q, k);
    }
  }
  return neighbours;
}

/// Keeps the largest connected piece of each patch's quads; the other quads get -1.
void KeepLargestPieces(const Eigen::MatrixXi& neighbours, int patches, Eigen::VectorXi& patchOf)
{
  std::vector<std::vector<int>> largest(patches);
  std::vector<char> seen(patchOf.size(), 0);
  for (int first = 0; first < static_cast<int>(patchOf.size()); ++first)
  {
    if (seen[first])
    {
      continue;
    }
    std::vector<int> piece = { first };
    seen[first] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      for (const int next : neighbours.row(piece[i]))
      {
        if (!seen[next] && patchOf(next) == patchOf(first))
        {
          seen[next] = 1;
          piece.push_back(next);
        }
      }
    }
    std::vector<int>& best = largest[patchOf(first)];
    if (piece.size() > best.size())
    {
      best = std::move(piece);
    }
  }
  Eigen::VectorXi kept = Eigen::VectorXi::Constant(patchOf.size(), -1);
  for (int patch = 0; patch < patches; ++patch)
  {
    for (const int quad : largest[patch])
    {
      kept(quad) = patch;
    }
  }
  patchOf.swap(kept);
}

} // namespace

// 1. Each quad gets the patch closest to its centroid; only the largest piece of each patch is
//    kept.
// 2. Other quads are reached from these pieces, closest first, as in Dijkstra's algorithm with the
//    distance to the patch as key. Each patch thus stays connected.
// 3. Quads with three edges on another patch join it.
// 4. MatchCornerValences: points with the rings of the surface's corners.
// 5. SplitPinches: points at which a patch touches itself.
Eigen::VectorXi AssignQuadsToPatches(const Eigen::MatrixXd& points, const QuadSurface& boundary,
  const Surface& surface, const SurfaceFeatures& features, const std::vector<Surface>& patches)
{
  const Eigen::MatrixXi& quads = boundary.Quads();
  if (features.Patches == 1)
  {
    return Eigen::VectorXi::Zero(quads.rows());
  }
  const Eigen::MatrixXd centres = ComputeQuadCentres(points, quads);
  const Eigen::MatrixXi neighbours = NeighboursOf(boundary);
  Eigen::VectorXi patchOf = features.PatchOf(SurfaceLocator(surface).Find(centres).Triangles);
  KeepLargestPieces(neighbours, features.Patches, patchOf);
  // Distances to single patches, for the quads that are reached from the pieces.
  const std::vector<SurfaceLocator> locators(patches.begin(), patches.end());
  using Candidate = std::tuple<double, int, int>; // distance, quad, patch
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
  const auto offer = [&](int quad, int patch)
  { open.emplace(locators[patch].Find(centres.row(quad)).Distances(0), quad, patch); };
  for (int q = 0; q < static_cast<int>(quads.rows()); ++q)
  {
    for (const int next : neighbours.row(q))
    {
      if (patchOf(q) < 0 && patchOf(next) >= 0)
      {
        offer(q, patchOf(next));
      }
    }
  }
  while (!open.empty())
  {
    const auto [distance, quad, patch] = open.top();
    open.pop();
    if (patchOf(quad) >= 0)
    {
      continue;
    }
    patchOf(quad) = patch;
    for (const int next : neighbours.row(quad))
    {
      if (patchOf(next) < 0)
      {
        offer(next, patch);
      }
    }
  }
  if (patchOf.minCoeff() < 0)
  {
    return {}; // no patch reaches a component of the boundary
  }
  // A quad with three consecutive edges on a curve could never be good.
  for (bool changed = true; changed;)
  {
    changed = false;
    for (int q = 0; q < static_cast<int>(quads.rows()); ++q)
    {
      std::map<int, int> edges;
      for (const int next : neighbours.row(q))
      {
        ++edges[patchOf(next)];
      }
      for (const auto& [patch, count] : edges)
      {
        if (patch != patchOf(q) && count >= 3)
        {
          patchOf(q) = patch;
          changed = true;
          break;
        }
      }
    }
  }
  MatchCornerValences(points, boundary, surface, features, patchOf);
  SplitPinches(
    boundary, FindCornerRings(surface, features),
    [&](int quad, int patch) { return locators[patch].Find(centres.row(quad)).Distances(0); },
    patchOf);
  return patchOf;
}

} // namespace shape
