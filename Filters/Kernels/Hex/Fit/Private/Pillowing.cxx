#include "Hex/Fit/Private/Pillowing.h"

#include "Mesh/QuadSurface.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace shape
{

namespace
{

/// The stacks of points under the boundary, for SmoothPillows.
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

std::vector<int> PadQuads(HexMesh& mesh, const Eigen::MatrixXi& quads)
{
  std::vector<int> copyOf(mesh.Points.rows(), -1);
  for (const int point : quads.reshaped())
  {
    copyOf[point] = 0;
  }
  auto count = static_cast<int>(mesh.Points.rows());
  for (int& copy : copyOf)
  {
    copy = copy < 0 ? -1 : count++;
  }
  mesh.Points.conservativeResize(count, 3);
  for (std::size_t point = 0; point < copyOf.size(); ++point)
  {
    if (copyOf[point] >= 0)
    {
      mesh.Points.row(copyOf[point]) = mesh.Points.row(static_cast<Eigen::Index>(point));
    }
  }
  // All hexahedra withdraw from the boundary to the copies; the new layer fills the gap.
  for (int& point : mesh.Hexahedra.reshaped())
  {
    point = copyOf[point] >= 0 ? copyOf[point] : point;
  }
  const Eigen::Index cells = mesh.Hexahedra.rows();
  mesh.Hexahedra.conservativeResize(cells + quads.rows(), 8);
  for (Eigen::Index q = 0; q < quads.rows(); ++q)
  {
    for (int k = 0; k < 4; ++k)
    {
      // Copies below, original points above: seen from outside the quad is counter-clockwise, so
      // the hexahedron is positive.
      mesh.Hexahedra(cells + q, k) = copyOf[quads(q, k)];
      mesh.Hexahedra(cells + q, k + 4) = quads(q, k);
    }
  }
  return copyOf;
}

namespace
{

/// Finds, for each quad, the hexahedron among some that has it as a face.
std::vector<int> FindHexahedraAt(
  const Eigen::MatrixXi& hexahedra, const std::vector<int>& rows, const Eigen::MatrixXi& quads)
{
  // A face's corners in ascending order: both hexahedra of the face give the same key.
  using Key = std::array<int, 4>;
  std::vector<std::pair<Key, int>> keys;
  std::vector<char> isCorner(hexahedra.maxCoeff() + 1, 0);
  for (int q = 0; q < static_cast<int>(quads.rows()); ++q)
  {
    Key key{};
    for (int k = 0; k < 4; ++k)
    {
      key[k] = quads(q, k);
      isCorner[key[k]] = 1;
    }
    std::sort(key.begin(), key.end());
    keys.emplace_back(key, q);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> found(quads.rows(), -1);
  for (const int row : rows)
  {
    for (const auto& face : HexFaces)
    {
      if (!std::all_of(std::begin(face), std::end(face),
            [&](int corner) { return isCorner[hexahedra(row, corner)]; }))
      {
        continue;
      }
      Key key{};
      for (int k = 0; k < 4; ++k)
      {
        key[k] = hexahedra(row, face[k]);
      }
      std::sort(key.begin(), key.end());
      const auto quad = std::lower_bound(keys.begin(), keys.end(), std::pair(key, -1));
      if (quad != keys.end() && quad->first == key)
      {
        found[quad->second] = row;
      }
    }
  }
  return found;
}

} // namespace

std::vector<int> PadSide(HexMesh& mesh, const std::vector<int>& rows, const Eigen::MatrixXi& quads,
  std::vector<int>& regionOf)
{
  for (const int hex : FindHexahedraAt(mesh.Hexahedra, rows, quads))
  {
    regionOf.push_back(int(regionOf[hex]));
  }
  HexMesh side{ std::move(mesh.Points), mesh.Hexahedra(rows, Eigen::all) };
  std::vector<int> copyOf = PadQuads(side, quads);
  const Eigen::Index before = mesh.Hexahedra.rows(), added = quads.rows();
  mesh.Points = std::move(side.Points);
  mesh.Hexahedra.conservativeResize(before + added, 8);
  mesh.Hexahedra(rows, Eigen::all) = side.Hexahedra.topRows(static_cast<Eigen::Index>(rows.size()));
  mesh.Hexahedra.bottomRows(added) = side.Hexahedra.bottomRows(added);
  return copyOf;
}

/// Inserts a sheet (Ledoux and Shepherd 2010): the layer is added under the patches, the other
/// quads take the copies, and the sides of the layer become quads of the adjacent patches.
void PillowPatches(HexMesh& mesh, const std::vector<int>& patches, PatchedBoundary& boundary)
{
  const QuadSurface before(boundary.Quads);
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
  // Beyond these patches the copies replace the original points.
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
  for (const auto& [edge, quad] : before.Edges())
  {
    const int beyond = boundary.PatchOf(before.QuadAt({ edge.second, edge.first }));
    if (isPadded(boundary.PatchOf(quad)) && !isPadded(beyond))
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

void PillowBoundary(HexMesh& mesh, PatchedBoundary& boundary)
{
  RememberCopies(PadQuads(mesh, boundary.Quads), boundary);
  boundary.CurveOf.resize(mesh.Points.rows(), -1);
  boundary.CornerOf.resize(mesh.Points.rows(), -1);
}

void PillowSide(HexMesh& mesh, std::vector<int> rows, int layers, PatchedBoundary& boundary,
  std::vector<int>& regionOf)
{
  for (int layer = 0; layer < layers; ++layer)
  {
    const auto first = static_cast<int>(mesh.Hexahedra.rows());
    RememberCopies(PadSide(mesh, rows, boundary.Quads, regionOf), boundary);
    // The next layer lies between the quads and this one.
    rows.resize(rows.size() + static_cast<std::size_t>(boundary.Quads.rows()));
    std::iota(rows.end() - boundary.Quads.rows(), rows.end(), first);
  }
}

void SmoothPillows(const PatchedBoundary& boundary, Eigen::MatrixXd& points)
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
