#include "Hex/BoundaryLayers.h"

#include "Hex/Padding.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace shape
{

std::vector<int> PatchesBesideStraightCorners(
  const PatchedBoundary& boundary, const std::vector<int>& groups)
{
  const std::map<QuadEdge, int> patches = PatchesOfEdges(boundary);
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
  const std::map<QuadEdge, int> patchOfEdge = PatchesOfEdges(boundary);
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
