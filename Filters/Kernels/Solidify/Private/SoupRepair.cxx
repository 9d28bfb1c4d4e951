#include "Solidify/Private/SoupRepair.h"

#include "Base/DisjointSets.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/HalfEdges.h"
#include "Solidify/Private/EdgeGroups.h"
#include "Solidify/Private/JoinedSoup.h"

#include <algorithm>

namespace shape
{
namespace
{

/// The corner of a triangle opposite to its longest edge.
int FindMidpointCorner(const Mesh& mesh, int triangle)
{
  const Eigen::Matrix3d corners = GetCorners(mesh, triangle);
  int middle = 0;
  double longest = -1.0;
  for (int k = 0; k < 3; ++k)
  {
    const double length = (corners.row((k + 1) % 3) - corners.row((k + 2) % 3)).squaredNorm();
    if (length > longest)
    {
      longest = length;
      middle = k;
    }
  }
  return middle;
}

/// Triangles that come from the same one of the draft.
struct TrianglePart
{
  Eigen::RowVector3i Corners;
  int Source;
};

/// Returns the other triangles that have the edge of a half-edge, whose ends are a and c.
std::vector<int> FindOthersAtEdge(
  const std::vector<HalfEdge>& sorted, const Eigen::RowVector2i& ends, int triangle)
{
  const int low = ends.minCoeff(), high = ends.maxCoeff();
  const auto isBefore = [](const HalfEdge& side, const std::pair<int, int>& edge)
  { return std::make_pair(side.Low(), side.High()) < edge; };
  std::vector<int> others;
  for (auto side =
         std::lower_bound(sorted.begin(), sorted.end(), std::make_pair(low, high), isBefore);
       side != sorted.end() && side->Low() == low && side->High() == high; ++side)
  {
    if (side->Triangle != triangle)
    {
      others.push_back(side->Triangle);
    }
  }
  return others;
}

/// Replaces a triangle by its two parts on either side of a point on its edge; a part that has the
/// point as its own corner has no area and is left out.
void SplitTriangle(const Eigen::RowVector3i& corners, const Eigen::RowVector2i& ends, int point,
  int source, std::vector<TrianglePart>& parts)
{
  if ((corners.array() == point).any())
  {
    return;
  }
  for (int k = 0; k < 2; ++k)
  {
    parts.push_back({ corners.unaryExpr([&](int c) { return c == ends(k) ? point : c; }), source });
  }
}

/// One round: removes collinear triangles that do not affect each other.
void SplitOnce(MendedDraft& draft, const std::vector<int>& collinear)
{
  const Mesh& mesh = draft.Surface;
  const std::vector<HalfEdge> sorted = SortHalfEdges(mesh.Triangles, mesh.Points.rows());
  std::vector<char> isChanged(mesh.Triangles.rows(), 0);
  std::vector<TrianglePart> parts;
  for (const int t : collinear)
  {
    const int k = FindMidpointCorner(mesh, t);
    const Eigen::RowVector2i ends(mesh.Triangles(t, (k + 1) % 3), mesh.Triangles(t, (k + 2) % 3));
    const std::vector<int> others = FindOthersAtEdge(sorted, ends, t);
    if (isChanged[t] ||
      std::any_of(others.begin(), others.end(), [&](int other) { return isChanged[other]; }))
    {
      continue;
    }
    isChanged[t] = 1;
    for (const int other : others)
    {
      isChanged[other] = 1;
      SplitTriangle(
        mesh.Triangles.row(other), ends, mesh.Triangles(t, k), draft.Triangles[other], parts);
    }
  }
  std::vector<int> kept;
  for (int t = 0; t < static_cast<int>(isChanged.size()); ++t)
  {
    if (!isChanged[t])
    {
      kept.push_back(t);
    }
  }
  draft.Keep(kept);
  Eigen::Index row = draft.Surface.Triangles.rows();
  draft.Surface.Triangles.conservativeResize(row + static_cast<Eigen::Index>(parts.size()), 3);
  for (const TrianglePart& part : parts)
  {
    draft.Surface.Triangles.row(row++) = part.Corners;
    draft.Triangles.push_back(part.Source);
  }
}

} // namespace

void MendedDraft::Keep(const std::vector<int>& triangles)
{
  this->Surface.Triangles = this->Surface.Triangles(triangles, Eigen::all).eval();
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    this->Triangles[i] = this->Triangles[triangles[i]];
  }
  this->Triangles.resize(triangles.size());
}

int SplitAtCollinearCorners(MendedDraft& draft)
{
  // A split may give collinear parts, but shorter ones. Their number is small.
  constexpr int rounds = 50;
  int removed = 0;
  for (int round = 0; round <= rounds; ++round)
  {
    const std::vector<int> collinear = FindDegenerateTriangles(draft.Surface);
    if (collinear.empty())
    {
      break;
    }
    removed = round == 0 ? static_cast<int>(collinear.size()) : removed;
    if (round < rounds)
    {
      SplitOnce(draft, collinear);
      continue;
    }
    std::vector<int> kept;
    for (int t = 0; t < static_cast<int>(draft.Triangles.size()); ++t)
    {
      if (!std::binary_search(collinear.begin(), collinear.end(), t))
      {
        kept.push_back(t);
      }
    }
    draft.Keep(kept);
  }
  return removed;
}

int RemoveSameTriangles(MendedDraft& draft)
{
  const auto count = static_cast<int>(draft.Triangles.size());
  const std::vector<int> same = FindSameTriangles(draft.Surface.Triangles);
  std::vector<int> copies(count, 0), unique;
  for (int t = 0; t < count; ++t)
  {
    if (copies[same[t]]++ == 0)
    {
      unique.push_back(t);
    }
  }
  if (static_cast<int>(unique.size()) == count)
  {
    return 0;
  }
  draft.Keep(unique);
  std::vector<char> isWall(unique.size());
  for (std::size_t i = 0; i < unique.size(); ++i)
  {
    isWall[i] = copies[unique[i]] % 2 == 0;
  }
  // Regions of walls end at edges with other triangles.
  DisjointSets regions(static_cast<int>(unique.size()));
  std::vector<std::pair<int, int>> borders; // a wall, and the number of other triangles at an edge
  const std::vector<HalfEdge> sides =
    SortHalfEdges(draft.Surface.Triangles, draft.Surface.Points.rows());
  ForEachEdge(sides,
    [&](const HalfEdge* begin, const HalfEdge* end)
    {
      int wall = -1, others = 0;
      for (const HalfEdge* side = begin; side != end; ++side)
      {
        others += !isWall[side->Triangle];
        wall = isWall[side->Triangle] ? side->Triangle : wall;
      }
      for (const HalfEdge* side = begin; side != end && others == 0; ++side)
      {
        regions.Merge(side->Triangle, wall);
      }
      if (wall >= 0 && others > 0)
      {
        for (const HalfEdge* side = begin; side != end; ++side)
        {
          if (isWall[side->Triangle])
          {
            borders.emplace_back(side->Triangle, others);
          }
        }
      }
    });
  std::vector<char> isBordered(unique.size(), 0), isNeeded(unique.size(), 0);
  for (const auto& [wall, others] : borders)
  {
    const int region = regions.Find(wall);
    isBordered[region] = 1;
    isNeeded[region] = isNeeded[region] || others % 2 == 1;
  }
  std::vector<int> kept;
  for (int t = 0; t < static_cast<int>(unique.size()); ++t)
  {
    const int region = regions.Find(t);
    if (!isWall[t] || !isBordered[region] || isNeeded[region])
    {
      kept.push_back(t);
    }
  }
  draft.Keep(kept);
  return count - static_cast<int>(kept.size());
}

} // namespace shape
