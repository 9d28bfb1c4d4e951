#include "IO/MeshSets.h"

#include "Base/Errors.h"
#include "Mesh/CellFaces.h"
#include "Mesh/Topology.h"
#include "Quality/CellSimplices.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using namespace cell_kind;

void Check(const Cells& cells)
{
  if (cells.Kinds.size() == 0)
  {
    throw InvalidInput("the Input has no cells; connect a mesh with cells");
  }
  RequireFinite(cells.Points, "the Input");
  for (int cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    const int first = cells.Offsets(cell), count = cells.Offsets(cell + 1) - first;
    if (count == 0 || GetCornerCount(cells.Kinds(cell)) != count)
    {
      throw InvalidInput("the Input's cell " + std::to_string(cell) + " has VTK's cell type " +
        std::to_string(cells.Kinds(cell)) +
        ", which the file format does not support; remove cells of this type");
    }
    const auto corners = cells.Corners.segment(first, count);
    if (corners.minCoeff() < 0 || corners.maxCoeff() >= cells.Points.rows())
    {
      throw InvalidInput(
        "the Input's cell " + std::to_string(cell) + " refers to a missing point; repair the mesh");
    }
  }
}

void CheckRegions(const Cells& cells, const Eigen::VectorXi& regions)
{
  if (regions.size() != cells.Kinds.size())
  {
    throw InvalidInput("there are " + std::to_string(regions.size()) + " regions for " +
      std::to_string(cells.Kinds.size()) + " cells; give one region for each cell");
  }
  const auto negative = (regions.array() < 0).count();
  if (negative > 0)
  {
    throw InvalidInput("the region of " + std::to_string(negative) +
      (negative == 1 ? " cell" : " cells") + " is negative (first of cell " +
      std::to_string(std::find_if(regions.begin(), regions.end(), [](int r) { return r < 0; }) -
        regions.begin()) +
      "); number regions from 0");
  }
}

double WedgeVolume(const Cells& cells)
{
  CellSimplices simplices;
  for (Eigen::Index cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    if (cells.Kinds(cell) == Wedge)
    {
      simplices.Add(CellShape::Wedge, cells.Corners.data() + cells.Offsets(cell));
    }
  }
  double volume = 0.0;
  for (std::size_t i = 0; i < simplices.Corners.size(); ++i)
  {
    const std::array<int, 4>& c = simplices.Corners[i];
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k)
    {
      edges.row(k) = cells.Points.row(c[k + 1]) - cells.Points.row(c[0]);
    }
    volume += simplices.Shares[i] * edges.determinant();
  }
  return volume;
}

void TurnWedges(Cells& cells)
{
  for (Eigen::Index cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    if (cells.Kinds(cell) == Wedge)
    {
      const int first = cells.Offsets(cell);
      std::swap(cells.Corners(first + 1), cells.Corners(first + 2));
      std::swap(cells.Corners(first + 4), cells.Corners(first + 5));
    }
  }
}

/// Returns the given patch of each boundary face, or -1.
Eigen::VectorXi ReadGivenPatches(const MeshSets& sets, const Eigen::MatrixXi& facePatches)
{
  const SolidFaces& faces = sets.Boundary;
  Eigen::VectorXi patches = Eigen::VectorXi::Constant(faces.Cell.size(), -1);
  for (Eigen::Index face = 0; face < patches.size() && facePatches.size() > 0; ++face)
  {
    const int cell = faces.Cell(face);
    if (sets.Mesh.Kinds(cell) != Hexahedron)
    {
      continue;
    }
    patches(face) = facePatches(cell, faces.Face(face));
    if (patches(face) < -1 || patches(face) >= facePatches.size())
    {
      throw InvalidInput("the patch of a face of cell " + std::to_string(cell) + " is " +
        std::to_string(patches(face)) + "; number patches from 0");
    }
  }
  return patches;
}

/// Returns the patches that are given, and patches by the angle for the other faces.
Eigen::VectorXi FindPatches(
  const MeshSets& sets, const Eigen::MatrixXi& facePatches, double featureAngle)
{
  Eigen::VectorXi patches = ReadGivenPatches(sets, facePatches);
  std::vector<int> others;
  for (int face = 0; face < patches.size(); ++face)
  {
    if (patches(face) < 0)
    {
      others.push_back(face);
    }
  }
  const int first = patches.size() > 0 ? patches.maxCoeff() + 1 : 0;
  patches(others) =
    FindBoundaryPatches(sets.Mesh.Points, sets.Boundary.Corners(others, Eigen::all), featureAngle)
      .array() +
    first;
  return patches;
}

} // namespace

int GetDimension(int kind)
{
  return kind >= Tetrahedron                    ? 3
    : kind == Triangle || kind == Quadrilateral ? 2
    : kind == Line                              ? 1
                                                : 0;
}

MeshSets FindMeshSets(const Cells& cells, const Eigen::VectorXi& regions, double featureAngle,
  const Eigen::MatrixXi& facePatches, const Progress& progress)
{
  Check(cells);
  MeshSets sets;
  sets.Mesh = cells;
  sets.Regions = regions.size() > 0 ? regions : Eigen::VectorXi::Zero(cells.Kinds.size());
  CheckRegions(cells, sets.Regions);
  if (WedgeVolume(cells) < 0.0)
  {
    TurnWedges(sets.Mesh);
  }
  progress(0.2);
  for (const int kind : cells.Kinds)
  {
    sets.Dimension = std::max(sets.Dimension, GetDimension(kind));
  }
  sets.Boundary = FindBoundaryFaces(sets.Mesh);
  progress(0.5);
  sets.Patches = FindPatches(sets, facePatches, featureAngle);
  sets.PatchCount = sets.Patches.size() > 0 ? sets.Patches.maxCoeff() + 1 : 0;
  progress(0.8);
  sets.Interfaces = FindRegionInterfaces(sets.Mesh, sets.Regions);
  progress(1.0);
  return sets;
}

std::vector<std::vector<int>> GroupFacesByPatch(const MeshSets& sets)
{
  std::vector<std::vector<int>> faces(sets.PatchCount);
  for (int face = 0; face < sets.Patches.size(); ++face)
  {
    faces[sets.Patches(face)].push_back(face);
  }
  return faces;
}

std::vector<int> PointsOf(const Eigen::MatrixXi& faces, const std::vector<int>& chosen)
{
  std::vector<int> points;
  for (const int face : chosen)
  {
    std::copy_if(faces.row(face).begin(), faces.row(face).end(), std::back_inserter(points),
      [](int point) { return point >= 0; });
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

} // namespace shape
