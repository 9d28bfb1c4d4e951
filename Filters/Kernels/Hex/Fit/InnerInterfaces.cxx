#include "Hex/Fit/InnerInterfaces.h"

#include "Distance/HausdorffDistance.h"
#include "Hex/Fit/Private/Pillowing.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

namespace shape
{
namespace
{

/// A face's corners in ascending order: both hexahedra of the face give the same key.
std::array<int, 4> Sorted(const Eigen::RowVector4i& quad)
{
  std::array<int, 4> corners{ quad(0), quad(1), quad(2), quad(3) };
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Finds, for each quad, the hexahedron among some that has it as a face.
std::vector<int> HexahedraAt(
  const Eigen::MatrixXi& hexahedra, const std::vector<int>& rows, const Eigen::MatrixXi& quads)
{
  std::map<std::array<int, 4>, int> quadOf;
  for (int q = 0; q < static_cast<int>(quads.rows()); ++q)
  {
    quadOf[Sorted(quads.row(q))] = q;
  }
  std::vector<int> found(quads.rows(), -1);
  for (const int row : rows)
  {
    for (const auto& face : HexFaces)
    {
      Eigen::RowVector4i corners;
      for (int k = 0; k < 4; ++k)
      {
        corners(k) = hexahedra(row, face[k]);
      }
      const auto quad = quadOf.find(Sorted(corners));
      if (quad != quadOf.end())
      {
        found[quad->second] = row;
      }
    }
  }
  return found;
}

} // namespace

// Each side of an interface is pillowed separately: inside with the interface's quads, outside with
// the same quads reversed, so that both face out of their side.
InterfaceLayers::InterfaceLayers(HexMesh& mesh, const InnerInterfaces& interfaces, int layers)
{
  if (interfaces.Count() == 0)
  {
    return;
  }
  const RegionCells& cells = *interfaces.Cells;
  this->RegionOf.assign(cells.RegionOf.begin(), cells.RegionOf.end());
  for (std::size_t i = 0; i < interfaces.Count(); ++i)
  {
    // Layers of other interfaces have none of this one's points.
    std::vector<char> outside(cells.Inside[i].size());
    std::transform(cells.Inside[i].begin(), cells.Inside[i].end(), outside.begin(),
      [](char inside) { return static_cast<char>(inside == 0); });
    this->PillowSide(mesh, cells.Inside[i], cells.Interfaces[i], layers);
    this->PillowSide(mesh, outside, cells.Interfaces[i].rowwise().reverse(), layers);
  }
}

InterfaceLayers::InterfaceLayers(HexMesh& mesh, const Eigen::VectorXi& regionOf, int layers)
  : RegionOf(regionOf.begin(), regionOf.end())
{
  const std::set<int> regions(regionOf.begin(), regionOf.end());
  for (const int region : regions)
  {
    std::vector<char> side(regionOf.size());
    std::vector<int> rows;
    for (int hex = 0; hex < static_cast<int>(regionOf.size()); ++hex)
    {
      side[hex] = regionOf(hex) == region;
      if (side[hex])
      {
        rows.push_back(hex);
      }
    }
    const Eigen::MatrixXi quads =
      FindBoundaryQuads({ mesh.Points, mesh.Hexahedra(rows, Eigen::all) });
    this->PillowSide(mesh, side, quads, layers);
  }
}

void InterfaceLayers::PillowSide(
  HexMesh& mesh, const std::vector<char>& side, const Eigen::MatrixXi& quads, int layers)
{
  std::vector<int> rows;
  for (int hex = 0; hex < static_cast<int>(side.size()); ++hex)
  {
    if (side[hex])
    {
      rows.push_back(hex);
    }
  }
  const std::vector<int> beside = HexahedraAt(mesh.Hexahedra, rows, quads);
  PatchedBoundary copies;
  copies.Quads = quads;
  // Only the hexahedra of this side use the copies: those of the other side keep the interface's
  // points.
  HexMesh part{ mesh.Points, mesh.Hexahedra(rows, Eigen::all) };
  for (int layer = 0; layer < layers; ++layer)
  {
    PillowBoundary(part, copies);
    for (const int hex : beside)
    {
      this->RegionOf.push_back(int(this->RegionOf[hex]));
    }
  }
  const auto own = static_cast<Eigen::Index>(rows.size()), before = mesh.Hexahedra.rows();
  const Eigen::Index added = part.Hexahedra.rows() - own;
  mesh.Points = std::move(part.Points);
  mesh.Hexahedra.conservativeResize(before + added, 8);
  mesh.Hexahedra(rows, Eigen::all) = part.Hexahedra.topRows(own);
  mesh.Hexahedra.bottomRows(added) = part.Hexahedra.bottomRows(added);
  this->Sides.push_back(std::move(copies));
}

Eigen::VectorXi InterfaceLayers::Regions(Eigen::Index hexahedra) const
{
  Eigen::VectorXi regions = Eigen::VectorXi::Zero(hexahedra);
  std::copy(this->RegionOf.begin(), this->RegionOf.end(), regions.begin());
  return regions;
}

void InterfaceLayers::Spread(Eigen::MatrixXd& points) const
{
  for (const PatchedBoundary& side : this->Sides)
  {
    SmoothPillows(side, points);
  }
}

MultiSurfaceConstraint::MultiSurfaceConstraint(
  FeatureConstraint outer, const InnerInterfaces& interfaces, Eigen::Index points)
  : Outer(std::move(outer))
  , SurfaceOf(points, -1)
{
  for (std::size_t i = 0; i < interfaces.Count(); ++i)
  {
    const Surface& surface = (*interfaces.Surfaces)[i];
    const Eigen::MatrixXi& quads = interfaces.Cells->Interfaces[i];
    // The whole inner surface is one patch without curves: its creases are not kept.
    SurfaceFeatures features;
    features.Patches = 1;
    features.PatchOf = Eigen::VectorXi::Zero(surface.Triangles().rows());
    const PatchedBoundary smooth{ quads, Eigen::VectorXi::Zero(quads.rows()),
      std::vector<int>(points, -1), std::vector<int>(points, -1), {}, {}, {}, { surface } };
    this->Inner.emplace_back(surface, features, smooth, points);
    for (const int point : quads.reshaped())
    {
      this->SurfaceOf[point] = static_cast<int>(i);
    }
  }
}

const PointConstraint& MultiSurfaceConstraint::Of(int point) const
{
  const int surface = this->SurfaceOf[point];
  return surface < 0 ? this->Outer : this->Inner[surface];
}

int MultiSurfaceConstraint::Freedom(int point) const
{
  return this->Of(point).Freedom(point);
}

PointDirections MultiSurfaceConstraint::Directions(
  int point, const Eigen::RowVector3d& position) const
{
  return this->Of(point).Directions(point, position);
}

Eigen::RowVector3d MultiSurfaceConstraint::Nearest(
  int point, const Eigen::RowVector3d& position) const
{
  return this->Of(point).Nearest(point, position);
}

double ComputeInterfaceDistance(const Eigen::MatrixXd& points,
  const std::vector<Eigen::MatrixXi>& interfaces, const std::vector<Surface>& surfaces,
  const Progress& progress)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < interfaces.size(); ++i)
  {
    largest = std::max(largest,
      ComputeHausdorffDistance(surfaces[i], { points, SplitQuads(interfaces[i]) }, progress)
        .Larger());
  }
  return largest;
}

} // namespace shape
