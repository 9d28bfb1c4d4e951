#include "IO/BoundaryPatches.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/CellFaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

/// Collects faces in the order of their cells.
SolidFaces Collect(const Cells& cells, std::vector<CellFace> faces)
{
  std::sort(faces.begin(), faces.end(),
    [](const CellFace& a, const CellFace& b)
    { return std::tie(a.Cell, a.Face) < std::tie(b.Cell, b.Face); });
  const auto count = static_cast<Eigen::Index>(faces.size());
  SolidFaces result{ Eigen::MatrixXi::Constant(count, 4, -1), Eigen::VectorXi(count),
    Eigen::VectorXi(count) };
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const auto [points, cell, face] = faces[i];
    const std::vector<int>& corners = GetFaces(cells.Kinds(cell))[face];
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      result.Corners(i, static_cast<Eigen::Index>(k)) =
        cells.Corners(cells.Offsets(cell) + corners[k]);
    }
    result.Cell(i) = cell;
    result.Face(i) = face;
  }
  return result;
}

int Size(const Eigen::MatrixXi& faces, Eigen::Index face)
{
  return faces(face, 3) < 0 ? 3 : 4;
}

Eigen::Vector3d Normal(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& faces, Eigen::Index face)
{
  const auto edge = [&](int from, int to) -> Eigen::Vector3d
  { return (points.row(faces(face, to)) - points.row(faces(face, from))).transpose(); };
  return Size(faces, face) == 3 ? edge(0, 1).cross(edge(0, 2)) : edge(0, 2).cross(edge(1, 3));
}

/// Returns the angle between two vectors in degrees; 0 if one of them is zero.
double Angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::acos(-1.0);
}

} // namespace

SolidFaces FindBoundaryFaces(const Cells& cells)
{
  const std::vector<CellFace> all = SortFaces(cells);
  std::vector<CellFace> alone;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (IsBoundaryFace(all, i))
    {
      alone.push_back(all[i]);
    }
  }
  return Collect(cells, std::move(alone));
}

std::vector<RegionInterface> FindRegionInterfaces(
  const Cells& cells, const Eigen::VectorXi& regions)
{
  if (regions.size() == 0 || (regions.array() == regions(0)).all())
  {
    return {};
  }
  const std::vector<CellFace> all = SortFaces(cells);
  std::map<std::pair<int, int>, std::vector<CellFace>> between;
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    const int a = regions(all[i - 1].Cell), b = regions(all[i].Cell);
    if (all[i].Points == all[i - 1].Points && a != b)
    {
      between[std::minmax(a, b)].push_back(all[a < b ? i - 1 : i]);
    }
  }
  std::vector<RegionInterface> interfaces;
  for (auto& [pair, faces] : between)
  {
    interfaces.push_back({ pair.first, pair.second, Collect(cells, std::move(faces)) });
  }
  return interfaces;
}

Eigen::VectorXi FindBoundaryPatches(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& faces, double featureAngle)
{
  if (!(featureAngle >= 0.0 && featureAngle <= 180.0))
  {
    throw InvalidInput(
      "FeatureAngle is " + std::to_string(featureAngle) + "; it must be from 0 to 180 degrees");
  }
  std::vector<std::tuple<int, int, int>> edges; // both ends, ascending, and a face
  for (int face = 0; face < faces.rows(); ++face)
  {
    const int size = Size(faces, face);
    for (int k = 0; k < size; ++k)
    {
      const auto [low, high] = std::minmax({ faces(face, k), faces(face, (k + 1) % size) });
      edges.emplace_back(low, high, face);
    }
  }
  std::sort(edges.begin(), edges.end());
  const auto sameEdge = [&](std::size_t i, std::size_t j)
  {
    return j < edges.size() && std::get<0>(edges[i]) == std::get<0>(edges[j]) &&
      std::get<1>(edges[i]) == std::get<1>(edges[j]);
  };
  DisjointSets sets(static_cast<int>(faces.rows()));
  for (std::size_t first = 0, end = 0; first < edges.size(); first = end)
  {
    for (end = first + 1; sameEdge(first, end); ++end)
    {
    }
    const int a = std::get<2>(edges[first]), b = std::get<2>(edges[end - 1]);
    if (end - first == 2 &&
      Angle(Normal(points, faces, a), Normal(points, faces, b)) <= featureAngle)
    {
      sets.Merge(a, b);
    }
  }
  std::map<int, int> numbers;
  Eigen::VectorXi patches(faces.rows());
  for (int face = 0; face < faces.rows(); ++face)
  {
    patches(face) =
      numbers.emplace(sets.Find(face), static_cast<int>(numbers.size())).first->second;
  }
  return patches;
}

} // namespace shape
