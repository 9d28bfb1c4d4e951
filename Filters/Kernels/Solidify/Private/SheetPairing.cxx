#include "Solidify/Private/SheetPairing.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"
#include "Solidify/Private/CrossingCounter.h"
#include "Solidify/Private/EdgeGroups.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// Removes the most redundant sheets; returns the number of their triangles.
int RemoveMostRedundant(MendedDraft& draft, const Progress& progress)
{
  const auto count = static_cast<int>(draft.Triangles.size());
  const Surface surface = draft.Surface;
  DisjointSets sheets(count);
  std::vector<int> tangled; // triangles at edges with three or more
  ForEachEdge(surface.HalfEdges(),
    [&](const HalfEdge* begin, const HalfEdge* end)
    {
      if (end - begin == 2)
      {
        sheets.Merge(begin[0].Triangle, begin[1].Triangle);
      }
      for (const HalfEdge* side = begin; side != end && end - begin > 2; ++side)
      {
        tangled.push_back(side->Triangle);
      }
    });
  if (tangled.empty())
  {
    return 0;
  }
  std::map<int, std::vector<int>> candidates; // sheets by their roots
  for (const int t : tangled)
  {
    candidates[sheets.Find(t)];
  }
  for (int t = 0; t < count; ++t)
  {
    const auto sheet = candidates.find(sheets.Find(t));
    if (sheet != candidates.end())
    {
      sheet->second.push_back(t);
    }
  }
  constexpr int rays = 64;
  const CrossingCounter counter(surface);
  std::vector<std::pair<double, const std::vector<int>*>> redundancies;
  double most = 0.0;
  for (const auto& [root, triangles] : candidates)
  {
    progress(static_cast<double>(redundancies.size()) / static_cast<double>(candidates.size()));
    redundancies.emplace_back(counter.ComputeRedundancy(triangles, rays), &triangles);
    most = std::max(most, redundancies.back().first);
  }
  // A sheet of the boundary close to a wall seems redundant to many rays, but to fewer than the
  // wall does. It no longer does when the wall is removed.
  constexpr double least = 0.75, range = 0.05;
  std::vector<char> isRemoved(count, 0);
  for (const auto& [redundancy, triangles] : redundancies)
  {
    for (const int t : *triangles)
    {
      isRemoved[t] = redundancy >= std::max(least, most - range);
    }
  }
  std::vector<int> kept;
  for (int t = 0; t < count; ++t)
  {
    if (!isRemoved[t])
    {
      kept.push_back(t);
    }
  }
  draft.Keep(kept);
  return count - static_cast<int>(kept.size());
}

/// Pairs the triangles at edges.
class EdgePairs
{
public:
  EdgePairs(const Surface& surface, const Progress& progress)
    : Paired(surface)
    , Sides(surface.Triangles().rows() * 3, -1)
  {
    const std::vector<HalfEdge>& sorted = surface.HalfEdges();
    ForEachEdge(sorted,
      [&](const HalfEdge* begin, const HalfEdge* end)
      {
        if (end - begin == 2)
        {
          this->Pair(begin[0], begin[1]);
        }
        else if (end - begin > 2)
        {
          progress(static_cast<double>(begin - sorted.data()) / static_cast<double>(sorted.size()));
          this->PairAround(begin, end);
        }
      });
  }

  /// For each half-edge, the one that it is paired with, or -1.
  const std::vector<int>& Twins() const { return this->Sides; }

private:
  void Pair(const HalfEdge& one, const HalfEdge& other)
  {
    const int side = 3 * one.Triangle + one.Corner, twin = 3 * other.Triangle + other.Corner;
    this->Sides[side] = twin;
    this->Sides[twin] = side;
  }

  /// The half-edges of one edge: those on either side of a wedge that is inside are paired.
  void PairAround(const HalfEdge* begin, const HalfEdge* end)
  {
    const Eigen::MatrixXd& points = this->Paired.Points();
    const RowVector3d low = points.row(begin->Low()), high = points.row(begin->High());
    const RowVector3d axis = (high - low).normalized();
    // Two directions across the edge, and the angle of each triangle between them.
    Eigen::Index least;
    axis.cwiseAbs().minCoeff(&least);
    const RowVector3d across = axis.cross(RowVector3d::Unit(least)).normalized();
    const RowVector3d up = axis.cross(across);
    std::vector<std::pair<double, const HalfEdge*>> around;
    for (const HalfEdge* side = begin; side != end; ++side)
    {
      const RowVector3d away =
        points.row(this->Paired.Triangles()(side->Triangle, (side->Corner + 2) % 3)) - low;
      around.emplace_back(std::atan2(away.dot(up), away.dot(across)), side);
    }
    std::sort(around.begin(), around.end());
    if (!this->Counter)
    {
      this->Counter.emplace(this->Paired);
    }
    constexpr int rays = 31;
    constexpr double distance = 1e-4; // in lengths of the edge
    std::vector<char> isTaken(around.size(), 0);
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      const std::size_t next = (i + 1) % around.size();
      double width = around[next].first - around[i].first;
      width += next == 0 ? 2.0 * M_PI : 0.0;
      const double angle = around[i].first + 0.5 * width;
      const RowVector3d position = 0.5 * (low + high) +
        distance * (high - low).norm() * (std::cos(angle) * across + std::sin(angle) * up);
      if (!isTaken[i] && !isTaken[next] && this->Counter->IsInside(position, begin->Begin, rays))
      {
        this->Pair(*around[i].second, *around[next].second);
        isTaken[i] = isTaken[next] = 1;
      }
    }
  }

  Surface Paired;
  std::vector<int> Sides;
  std::optional<CrossingCounter> Counter; ///< made if it is needed
};

/// Returns which triangles must be reversed so that paired half-edges run in opposite directions.
std::vector<char> FindReversed(const Mesh& mesh, const std::vector<int>& twins)
{
  const auto count = static_cast<int>(mesh.Triangles.rows());
  const auto beginOf = [&](int side) { return mesh.Triangles(side / 3, side % 3); };
  std::vector<int> state(count, -1); // 1: reversed
  std::vector<char> isReversed(count, 0);
  for (int first = 0; first < count; ++first)
  {
    if (state[first] >= 0)
    {
      continue;
    }
    std::vector<int> piece = { first };
    state[first] = 0;
    int changed = 0;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      const int t = piece[i];
      changed += state[t];
      for (int side = 3 * t; side < 3 * t + 3; ++side)
      {
        const int twin = twins[side];
        if (twin < 0)
        {
          continue;
        }
        const int wanted = state[t] ^ (beginOf(side) == beginOf(twin) ? 1 : 0);
        if (state[twin / 3] < 0)
        {
          state[twin / 3] = wanted;
          piece.push_back(twin / 3);
        }
        else if (state[twin / 3] != wanted)
        {
          throw InvalidInput(
            "the surface has a piece with only one side, as a Moebius strip (at point " +
            std::to_string(beginOf(side)) + "); cut it open, or remove it");
        }
      }
    }
    const int wrong = 2 * changed > static_cast<int>(piece.size()) ? 0 : 1;
    for (const int t : piece)
    {
      isReversed[t] = state[t] == wrong;
    }
  }
  return isReversed;
}

/// Returns the fan of each corner (3 t + k), connected by pairs. At a point with several open fans,
/// these count as one.
std::vector<int> FindPairedFans(const Mesh& mesh, const std::vector<int>& twins)
{
  const auto corners = static_cast<int>(twins.size());
  const auto pointOf = [&](int corner) { return mesh.Triangles(corner / 3, corner % 3); };
  DisjointSets fans(corners);
  std::vector<int> openFan(mesh.Points.rows(), -1);
  for (int side = 0; side < corners; ++side)
  {
    const int next = NextHalfEdge(side), twin = twins[side];
    if (twin >= 0)
    {
      const int twinNext = NextHalfEdge(twin);
      const bool isOpposite = pointOf(side) == pointOf(twinNext);
      fans.Merge(side, isOpposite ? twinNext : twin);
      fans.Merge(next, isOpposite ? twin : twinNext);
      continue;
    }
    for (const int corner : { side, next })
    {
      int& open = openFan[pointOf(corner)];
      open = open < 0 ? corner : open;
      fans.Merge(corner, open);
    }
  }
  std::vector<int> fanOf(corners);
  for (int corner = 0; corner < corners; ++corner)
  {
    fanOf[corner] = fans.Find(corner);
  }
  return fanOf;
}

/// Gives each further fan at a point a copy of the point. Returns the number of copies.
int CopyPoints(MendedDraft& draft, const std::vector<int>& fanOf)
{
  Eigen::MatrixXi& triangles = draft.Surface.Triangles;
  const std::size_t before = draft.Points.size();
  std::vector<int> firstFan(before, -1);
  std::vector<int> copied;   // for each copy, the draft's point
  std::map<int, int> copyOf; // from further fans to their points
  for (int corner = 0; corner < static_cast<int>(fanOf.size()); ++corner)
  {
    int& point = triangles(corner / 3, corner % 3);
    if (firstFan[point] < 0)
    {
      firstFan[point] = fanOf[corner];
    }
    if (firstFan[point] != fanOf[corner])
    {
      const auto [copy, isNew] =
        copyOf.insert({ fanOf[corner], static_cast<int>(before + copied.size()) });
      if (isNew)
      {
        copied.push_back(point);
      }
      point = copy->second;
    }
  }
  Eigen::MatrixXd& points = draft.Surface.Points;
  points.conservativeResize(static_cast<Eigen::Index>(before + copied.size()), 3);
  for (const int point : copied)
  {
    points.row(static_cast<Eigen::Index>(draft.Points.size())) = points.row(point).eval();
    draft.Points.push_back(draft.Points[point]);
  }
  return static_cast<int>(copied.size());
}

} // namespace

int RemoveRedundantSheets(MendedDraft& draft, const Progress& progress)
{
  constexpr int rounds = 8;
  int removed = 0;
  for (int round = 0; round < rounds && !draft.Triangles.empty(); ++round)
  {
    const int now = RemoveMostRedundant(draft,
      progress.Part(static_cast<double>(round) / rounds, static_cast<double>(round + 1) / rounds));
    removed += now;
    if (now == 0)
    {
      break;
    }
  }
  return removed;
}

SeparatedSheets SeparateSheets(MendedDraft& draft, const Progress& progress)
{
  const EdgePairs pairs(draft.Surface, progress);
  const std::vector<char> isReversed = FindReversed(draft.Surface, pairs.Twins());
  SeparatedSheets separated;
  separated.SplitPoints = CopyPoints(draft, FindPairedFans(draft.Surface, pairs.Twins()));
  for (int t = 0; t < static_cast<int>(isReversed.size()); ++t)
  {
    if (isReversed[t])
    {
      std::swap(draft.Surface.Triangles(t, 1), draft.Surface.Triangles(t, 2));
      ++separated.Reversed;
    }
  }
  return separated;
}

} // namespace shape
