#include "Hex/Fit/InnerInterfaces.h"

#include "Distance/HausdorffDistance.h"
#include "Hex/Fit/Private/Pillowing.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

std::vector<int> FindRows(const std::vector<char>& marked)
{
  std::vector<int> rows;
  for (int row = 0; row < static_cast<int>(marked.size()); ++row)
  {
    if (marked[row])
    {
      rows.push_back(row);
    }
  }
  return rows;
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
    this->PillowSide(mesh, FindRows(cells.Inside[i]), cells.Interfaces[i], layers);
    this->PillowSide(mesh, FindRows(outside), cells.Interfaces[i].rowwise().reverse(), layers);
  }
}

InterfaceLayers::InterfaceLayers(HexMesh& mesh, const Eigen::VectorXi& regionOf, int layers)
  : RegionOf(regionOf.begin(), regionOf.end())
{
  std::map<int, std::vector<int>> rowsOf;
  for (int hex = 0; hex < static_cast<int>(regionOf.size()); ++hex)
  {
    rowsOf[regionOf(hex)].push_back(hex);
  }
  for (const auto& [region, rows] : rowsOf)
  {
    const Eigen::MatrixXi quads =
      FindBoundaryQuads({ mesh.Points, mesh.Hexahedra(rows, Eigen::all) });
    this->PillowSide(mesh, rows, quads, layers);
  }
}

void InterfaceLayers::PillowSide(
  HexMesh& mesh, const std::vector<int>& rows, const Eigen::MatrixXi& quads, int layers)
{
  PatchedBoundary copies;
  copies.Quads = quads;
  shape::PillowSide(mesh, rows, layers, copies, this->RegionOf);
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
