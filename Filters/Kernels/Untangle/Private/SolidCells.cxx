#include "Untangle/Private/SolidCells.h"

#include "Base/Errors.h"
#include "Geometry/PositiveTetrahedron.h"
#include "Mesh/CellFaces.h"
#include "Quality/CellSimplices.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

using namespace cell_kind;

/// Edges of length 1 from a corner of the regular cell.
Eigen::Matrix3d RegularEdges(int kind)
{
  Eigen::Matrix3d edges = Eigen::Matrix3d::Identity();
  const double half = 0.5, height = std::sqrt(0.75);
  if (kind == Tetrahedron || kind == Wedge)
  {
    edges.col(1) << half, height, 0.0;
  }
  if (kind == Tetrahedron)
  {
    edges.col(2) << half, height / 3.0, std::sqrt(2.0 / 3.0);
  }
  else if (kind == Pyramid)
  {
    edges.col(2) << half, half, std::sqrt(half);
  }
  return edges;
}

long long KeyOf(int a, int b)
{
  return (static_cast<long long>(std::min(a, b)) << 32) | std::max(a, b);
}

CellShape ShapeOf(int kind)
{
  return kind == Tetrahedron ? CellShape::Tetrahedron
    : kind == Pyramid        ? CellShape::Pyramid
    : kind == Wedge          ? CellShape::Wedge
                             : CellShape::Hexahedron;
}

Eigen::Matrix3d EdgesOf(const Eigen::MatrixXd& points, const std::array<int, 4>& corners)
{
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k)
  {
    edges.col(k) = (points.row(corners[k + 1]) - points.row(corners[0])).transpose();
  }
  return edges;
}

} // namespace

SolidCells::SolidCells(const Cells& cells, const Eigen::MatrixXd& rest, const std::string& name,
  const Progress& progress)
  : Points(cells.Points)
  , Rest(rest)
  , OriginalPointCount(static_cast<int>(cells.Points.rows()))
{
  this->PointCells.resize(this->OriginalPointCount);
  for (int cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    if (cell % ReportInterval == 0)
    {
      progress(0.3 * cell / cells.Kinds.size());
    }
    const int first = cells.Offsets(cell), count = cells.Offsets(cell + 1) - first;
    const std::string where = name + "'s cell " + std::to_string(cell);
    if (GetFaces(cells.Kinds(cell)).empty() || GetCornerCount(cells.Kinds(cell)) != count)
    {
      throw InvalidInput(where +
        " is no tetrahedron, pyramid, wedge or hexahedron (VTK cell type " +
        std::to_string(cells.Kinds(cell)) +
        "); remove such cells with Extract Cells By Type, or split them with Tetrahedralize");
    }
    std::vector<int> corners(cells.Corners.begin() + first, cells.Corners.begin() + first + count);
    std::vector<int> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    if (sorted.front() < 0 || sorted.back() >= this->OriginalPointCount ||
      std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    {
      throw InvalidInput(where + " repeats a point or uses one that does not exist; repair it");
    }
    for (const int point : corners)
    {
      this->PointCells[point].push_back(cell);
    }
    this->Kinds.push_back(cells.Kinds(cell));
    this->Corners.push_back(std::move(corners));
    this->OriginalCells.push_back(cell);
  }
  if (this->Kinds.empty())
  {
    throw InvalidInput(name + " has no solid cells; make some with Shape Tetrahedralize");
  }
  this->MarkBoundary(cells, progress.Part(0.3, 1.0));
  this->TurnWedges();
}

void SolidCells::MarkBoundary(const Cells& cells, const Progress& progress)
{
  this->Boundary.assign(this->PointCells.size(), 0);
  const std::vector<CellFace> faces = SortFaces(cells);
  progress(0.8);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (i % ReportInterval == 0)
    {
      progress(0.8 + 0.2 * i / faces.size());
    }
    if (!IsBoundaryFace(faces, i))
    {
      continue;
    }
    std::vector<int> face;
    for (const int corner : GetFaces(this->Kinds[faces[i].Cell])[faces[i].Face])
    {
      face.push_back(this->Corners[faces[i].Cell][corner]);
    }
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      this->Boundary[face[k]] = 1;
      this->BoundaryEdges.insert(KeyOf(face[k], face[(k + 1) % face.size()]));
    }
    // The face as a fan of triangles.
    for (std::size_t k = 2; k < face.size(); ++k)
    {
      this->Surface.push_back({ face[0], face[k - 1], face[k] });
    }
  }
}

void SolidCells::SetInnerBoundary(const std::vector<std::array<int, 3>>& triangles)
{
  this->OuterSurface = std::exchange(this->Surface, triangles);
  for (const std::array<int, 3>& triangle : this->Surface)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Boundary[triangle[k]] = 1;
      this->BoundaryEdges.insert(KeyOf(triangle[k], triangle[(k + 1) % 3]));
    }
  }
}

void SolidCells::ForgetInnerBoundary()
{
  for (const std::array<int, 3>& triangle : this->Surface)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Boundary[triangle[k]] = 0;
      this->BoundaryEdges.erase(KeyOf(triangle[k], triangle[(k + 1) % 3]));
    }
  }
  this->Surface = std::move(this->OuterSurface);
}

void SolidCells::TurnWedges()
{
  // VTK's own sources number wedges in both orientations: the majority decides.
  const Eigen::MatrixXd& positions = this->Rest.rows() > 0 ? this->Rest : this->Points;
  int sum = 0;
  for (int cell = 0; cell < this->CellCount(); ++cell)
  {
    if (this->Kinds[cell] == Wedge)
    {
      for (const std::array<int, 4>& c : this->SimplicesOf(cell))
      {
        sum += EvaluateOrientation(
          positions.row(c[0]), positions.row(c[1]), positions.row(c[2]), positions.row(c[3]));
      }
    }
  }
  this->WedgesInverted = sum < 0;
}

std::vector<int> SolidCells::NeighboursOf(int point) const
{
  std::vector<int> all;
  for (const int cell : this->PointCells[point])
  {
    all.insert(all.end(), this->Corners[cell].begin(), this->Corners[cell].end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  all.erase(std::remove(all.begin(), all.end(), point), all.end());
  return all;
}

const std::vector<std::array<int, 4>>& SolidCells::SimplicesOf(int cell)
{
  const std::vector<int>& corners = this->Corners[cell];
  const int kind = this->Kinds[cell];
  this->Scratch.clear();
  if (kind == Tetrahedron)
  {
    this->Scratch.push_back({ corners[0], corners[1], corners[2], corners[3] });
    return this->Scratch;
  }
  CellSimplices simplices;
  simplices.Add(ShapeOf(kind), corners.data());
  this->Scratch = simplices.Corners;
  if (kind == Wedge && this->WedgesInverted)
  {
    for (std::array<int, 4>& simplex : this->Scratch)
    {
      std::swap(simplex[1], simplex[2]);
    }
  }
  return this->Scratch;
}

bool SolidCells::HasTetrahedra() const
{
  return std::find(this->Kinds.begin(), this->Kinds.end(), Tetrahedron) != this->Kinds.end();
}

bool SolidCells::HasOnlyTetrahedra() const
{
  return std::all_of(
    this->Kinds.begin(), this->Kinds.end(), [](int kind) { return kind == Tetrahedron; });
}

double SolidCells::ShareOf(int cell) const
{
  CellSimplices simplices;
  simplices.Add(ShapeOf(this->Kinds[cell]), this->Corners[cell].data());
  return simplices.Shares.front();
}

bool SolidCells::Inverted(int cell)
{
  const std::vector<std::array<int, 4>>& simplices = this->SimplicesOf(cell);
  return !std::all_of(simplices.begin(), simplices.end(),
    [&](const std::array<int, 4>& corners) { return IsPositive(this->Points, corners); });
}

Eigen::Matrix3d SolidCells::Reference(int cell, int k, double size)
{
  constexpr double flattest = 0.05;
  const Eigen::Matrix3d regular = RegularEdges(this->Kinds[cell]);
  if (this->Rest.rows() == 0)
  {
    return size * regular;
  }
  const Eigen::Matrix3d edges = EdgesOf(this->Rest, this->SimplicesOf(cell)[k]);
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
    edges * regular.inverse(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d values = svd.singularValues();
  if (values(0) <= 0.0)
  {
    return size * regular;
  }
  // The map from the regular cell to the rest shape is split into rotations and stretches. A
  // reflection is removed, and the smallest stretches are raised.
  Eigen::Matrix3d turned = svd.matrixU();
  if (turned.determinant() * svd.matrixV().determinant() < 0.0)
  {
    turned.col(2) *= -1.0;
  }
  const Eigen::Vector3d mended = values.cwiseMax(flattest * values(0));
  return size * turned * mended.asDiagonal() * svd.matrixV().transpose() * regular;
}

std::vector<int> SolidCells::CellsAround(const std::vector<int>& simplex) const
{
  std::vector<int> around;
  for (const int cell : this->PointCells[simplex[0]])
  {
    const std::vector<int>& corners = this->Corners[cell];
    if (std::all_of(simplex.begin(), simplex.end(),
          [&](int point)
          { return std::find(corners.begin(), corners.end(), point) != corners.end(); }))
    {
      around.push_back(cell);
    }
  }
  return around;
}

bool SolidCells::CanSplit(const std::vector<int>& simplex) const
{
  const std::vector<int> around = this->CellsAround(simplex);
  if (around.empty() ||
    std::any_of(
      around.begin(), around.end(), [&](int cell) { return this->Kinds[cell] != Tetrahedron; }))
  {
    return false;
  }
  // An inner edge, an inner face (two cells share it), or a cell.
  return simplex.size() == 2 ? this->BoundaryEdges.count(KeyOf(simplex[0], simplex[1])) == 0
                             : simplex.size() > 3 || around.size() == 2;
}

int SolidCells::Split(const std::vector<int>& simplex)
{
  const std::vector<int> around = this->CellsAround(simplex);
  const int middle = this->PointCount();
  this->KeepCells(around);
  const auto append = [&](Eigen::MatrixXd& positions)
  {
    // Reserves more, so that many splits do not copy all points each time.
    if (positions.rows() <= middle)
    {
      positions.conservativeResize(middle + 1 + middle / 8, 3);
    }
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    for (const int point : simplex)
    {
      mean += positions.row(point) / static_cast<double>(simplex.size());
    }
    positions.row(middle) = mean;
  };
  append(this->Points);
  if (this->Rest.rows() > 0)
  {
    append(this->Rest);
  }
  std::array<int, 4> parents = { -1, -1, -1, -1 };
  std::copy(simplex.begin(), simplex.end(), parents.begin());
  this->Parents.push_back(parents);
  this->PointCells.emplace_back();
  this->Boundary.push_back(0);
  for (const int cell : around)
  {
    // Part k has the new point in place of corner k of the simplex. Part 0 takes the place of the
    // cell.
    for (std::size_t k = 0; k < simplex.size(); ++k)
    {
      const int part = k == 0 ? cell : this->CellCount();
      if (k > 0)
      {
        this->Kinds.push_back(Tetrahedron);
        // The corners before this one are the middle in the cell itself only.
        this->Corners.push_back(this->Corners[cell]);
        std::replace(this->Corners[part].begin(), this->Corners[part].end(), middle, simplex[0]);
        this->OriginalCells.push_back(this->OriginalCells[cell]);
        for (const int point : this->Corners[part])
        {
          if (point != simplex[k])
          {
            this->PointCells[point].push_back(part);
          }
        }
      }
      else
      {
        std::vector<int>& cells = this->PointCells[simplex[0]];
        cells.erase(std::find(cells.begin(), cells.end(), cell));
      }
      std::replace(this->Corners[part].begin(), this->Corners[part].end(), simplex[k], middle);
      this->PointCells[middle].push_back(part);
    }
  }
  return middle;
}

void SolidCells::KeepState()
{
  this->Kept = State{ this->PointCount(), this->CellCount(), {}, {}, {} };
}

void SolidCells::KeepPositions(const std::vector<int>& points)
{
  for (const int point : points)
  {
    this->Kept->Positions.emplace_back(point, this->Points.row(point));
  }
}

/// Keeps cells that are going to be split, and which cells are around their points.
void SolidCells::KeepCells(const std::vector<int>& cells)
{
  if (!this->Kept)
  {
    return;
  }
  std::set<int> points;
  for (const int cell : cells)
  {
    this->Kept->Corners.emplace_back(cell, this->Corners[cell]);
    points.insert(this->Corners[cell].begin(), this->Corners[cell].end());
  }
  for (const int point : points)
  {
    this->Kept->PointCells.emplace_back(point, this->PointCells[point]);
  }
}

void SolidCells::RestoreState()
{
  State& kept = *this->Kept;
  for (; !kept.Positions.empty(); kept.Positions.pop_back())
  {
    this->Points.row(kept.Positions.back().first) = kept.Positions.back().second;
  }
  for (; !kept.Corners.empty(); kept.Corners.pop_back())
  {
    this->Corners[kept.Corners.back().first] = std::move(kept.Corners.back().second);
  }
  for (; !kept.PointCells.empty(); kept.PointCells.pop_back())
  {
    this->PointCells[kept.PointCells.back().first] = std::move(kept.PointCells.back().second);
  }
  this->PointCells.resize(kept.PointCount);
  this->Boundary.resize(kept.PointCount);
  this->Parents.resize(kept.PointCount - this->OriginalPointCount);
  this->Kinds.resize(kept.CellCount);
  this->Corners.resize(kept.CellCount);
  this->OriginalCells.resize(kept.CellCount);
}

Cells SolidCells::Result() const
{
  Cells cells{ this->Points.topRows(this->PointCount()), Eigen::VectorXi(this->CellCount()),
    Eigen::VectorXi(this->CellCount() + 1), Eigen::VectorXi() };
  std::vector<int> corners;
  cells.Offsets(0) = 0;
  for (int cell = 0; cell < this->CellCount(); ++cell)
  {
    cells.Kinds(cell) = this->Kinds[cell];
    corners.insert(corners.end(), this->Corners[cell].begin(), this->Corners[cell].end());
    cells.Offsets(cell + 1) = static_cast<int>(corners.size());
  }
  cells.Corners =
    Eigen::Map<Eigen::VectorXi>(corners.data(), static_cast<Eigen::Index>(corners.size()));
  return cells;
}

} // namespace shape
