#include "Hex/HexGrid.h"

#include "Base/DisjointSets.h"
#include "Hex/Private/HarmonicExtension.h"
#include "Mesh/CellFaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector3d;
using Eigen::RowVector3i;

/// The position of a corner of a cell, in cells, from its first corner.
RowVector3i CornerOffset(int corner)
{
  return { corner % 4 == 1 || corner % 4 == 2 ? 1 : 0, corner % 4 > 1 ? 1 : 0, corner / 4 };
}

using Box = Eigen::AlignedBox3d;

/// Returns how far a box has to move along x to be apart from all others.
double FindFreeShift(const Box& box, const std::vector<Box>& others)
{
  double shift = 0.0;
  for (bool isFree = false; !isFree;)
  {
    isFree = true;
    for (const Box& other : others)
    {
      const Box moved = box.translated(Eigen::Vector3d(shift, 0.0, 0.0));
      if (moved.intersects(other))
      {
        shift += other.max()(0) + 1.0 - moved.min()(0);
        isFree = false;
      }
    }
  }
  return shift;
}

/// Returns the positions, in cells, of the points of an image's cells. Each component begins near
/// its hexahedra, and is moved until it is apart from those before.
Eigen::MatrixXd PlaceCells(
  const Eigen::MatrixXi& cells, const HexMesh& solid, double cellSize, const Progress& progress)
{
  std::vector<std::vector<int>> cellsAt(solid.Points.rows());
  for (int cell = 0; cell < static_cast<int>(cells.rows()); ++cell)
  {
    for (const int point : cells.row(cell))
    {
      cellsAt[point].push_back(cell);
    }
  }
  Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(solid.Points.rows(), 3);
  std::vector<char> isPlaced(cells.rows(), 0);
  std::vector<int> placed;
  std::vector<Box> boxes;
  const auto place = [&](int cell, const RowVector3d& first)
  {
    isPlaced[cell] = 1;
    placed.push_back(cell);
    for (int corner = 0; corner < 8; ++corner)
    {
      positions.row(cells(cell, corner)) = first + CornerOffset(corner).cast<double>();
    }
  };
  for (int start = 0; start < static_cast<int>(cells.rows()); ++start)
  {
    if (isPlaced[start])
    {
      continue;
    }
    placed.clear();
    place(start, (solid.Points.row(cells(start, 0)) / cellSize).array().round().matrix());
    for (std::size_t i = 0; i < placed.size(); ++i)
    {
      if (i % 4096 == 0)
      {
        progress(0.0);
      }
      for (const int point : cells.row(placed[i]))
      {
        for (const int cell : cellsAt[point])
        {
          int corner = 0;
          for (; cells(cell, corner) != point; ++corner)
          {
          }
          if (!isPlaced[cell])
          {
            place(cell, positions.row(point) - CornerOffset(corner).cast<double>());
          }
        }
      }
    }
    std::vector<int> points;
    for (const int cell : placed)
    {
      points.insert(points.end(), cells.row(cell).begin(), cells.row(cell).end());
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    Box box;
    for (const int point : points)
    {
      box.extend(positions.row(point).transpose());
    }
    const double shift = FindFreeShift(box, boxes);
    for (const int point : points)
    {
      positions(point, 0) += shift;
    }
    boxes.push_back(box.translated(Eigen::Vector3d(shift, 0.0, 0.0)));
  }
  return positions;
}

/// Finds the positions of points in layers from those of the grid's points.
void PlaceLayers(const HexFit& fit, Eigen::MatrixXd& positions, const Progress& progress)
{
  std::vector<char> isGiven(positions.rows(), 0), isOuter(positions.rows(), 0);
  for (const int point : fit.Core.reshaped())
  {
    isGiven[point] = 1;
  }
  std::vector<std::pair<int, int>> edges;
  for (Eigen::Index quad = 0; quad < fit.Quads.rows(); ++quad)
  {
    for (int k = 0; k < 4; ++k)
    {
      isOuter[fit.Quads(quad, k)] = 1;
      edges.emplace_back(fit.Quads(quad, k), fit.Quads(quad, (k + 1) % 4));
    }
  }
  // Layers end on the boundary beside creases, whose points stay on the boundary of the grid.
  std::vector<char> isKnown = isGiven;
  for (std::size_t point = 0; point < isKnown.size(); ++point)
  {
    isKnown[point] = isGiven[point] != 0 || isOuter[point] == 0 ? 1 : 0;
  }
  const Eigen::MatrixXd given = positions;
  HarmonicExtension(edges, isKnown, progress.Part(0.0, 0.3)).Extend(positions);
  for (std::size_t point = 0; point < isKnown.size(); ++point)
  {
    isKnown[point] = isGiven[point] != 0 || isOuter[point] != 0 ? 1 : 0;
  }
  HarmonicExtension(ListHexEdges(fit.Solid.Hexahedra), isKnown, progress.Part(0.3, 0.9))
    .Extend(positions, progress.Part(0.9, 1.0));
}

/// The other cells across the faces of the cells of a grid. Side 2 a is the lower side along axis
/// a, and 2 a + 1 the upper one.
class CellNeighbours
{
public:
  CellNeighbours(const Eigen::MatrixXi& cells, const Eigen::MatrixXi& first)
    : Next(Eigen::MatrixXi::Constant(cells.rows(), 6, -1))
  {
    Cells hexahedra;
    hexahedra.Kinds = Eigen::VectorXi::Constant(cells.rows(), cell_kind::Hexahedron);
    hexahedra.Offsets =
      Eigen::VectorXi::LinSpaced(cells.rows() + 1, 0, static_cast<int>(cells.size()));
    hexahedra.Corners = cells.transpose().reshaped();
    const std::vector<CellFace> faces = SortFaces(hexahedra);
    for (std::size_t i = 1; i < faces.size(); ++i)
    {
      const int one = faces[i - 1].Cell, other = faces[i].Cell;
      if (faces[i].Points == faces[i - 1].Points)
      {
        int axis = 0;
        const RowVector3i way = first.row(other) - first.row(one);
        way.cwiseAbs().maxCoeff(&axis);
        const int side = 2 * axis + (way(axis) > 0 ? 1 : 0);
        this->Next(one, side) = other;
        this->Next(other, side ^ 1) = one;
      }
    }
  }

  int Count() const { return static_cast<int>(this->Next.rows()); }

  /// Returns -1 at the boundary.
  int Across(int cell, int side) const { return this->Next(cell, side); }

private:
  Eigen::MatrixXi Next;
};

/// For each cell and side, whether a wall between blocks is there.
std::vector<std::array<char, 6>> FindWalls(const CellNeighbours& neighbours)
{
  std::vector<std::array<char, 6>> walls(neighbours.Count(), std::array<char, 6>{});
  std::vector<std::pair<int, int>> found;
  const auto add = [&](int cell, int side)
  {
    if (!walls[cell][side])
    {
      const int other = neighbours.Across(cell, side);
      walls[cell][side] = 1;
      walls[other][side ^ 1] = 1;
      found.emplace_back(cell, side);
    }
  };
  // Calls a function with each direction along the side, the cell beside `cell` there, and whether
  // its side is on the boundary.
  const auto visitBeside = [&](int cell, int side, const auto& visit)
  {
    for (int way = 0; way < 6; ++way)
    {
      const int beside = way / 2 == side / 2 ? -1 : neighbours.Across(cell, way);
      if (beside >= 0)
      {
        visit(way, beside, neighbours.Across(beside, side) < 0);
      }
    }
  };
  for (int cell = 0; cell < neighbours.Count(); ++cell)
  {
    for (int side = 0; side < 6; ++side)
    {
      if (neighbours.Across(cell, side) >= 0)
      {
        visitBeside(cell, side,
          [&](int, int, bool isBoundary)
          {
            if (isBoundary)
            {
              add(cell, side);
            }
          });
      }
    }
  }
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const auto [cell, side] = found[i];
    visitBeside(cell, side,
      [&, cell = cell, side = side](int way, int beside, bool isBoundary)
      {
        // Where the boundary is a slit between faces that touch, a wall across its end keeps a side
        // from lying partly on the boundary and partly on another block.
        isBoundary ? add(cell, way) : add(beside, side);
      });
  }
  return walls;
}

/// Finds the blocks and the indices of cells in them. first: the position of each cell, in cells.
void FindBlocks(const Eigen::MatrixXi& first, HexGrid& grid)
{
  const CellNeighbours neighbours(grid.Cells, first);
  const std::vector<std::array<char, 6>> walls = FindWalls(neighbours);
  DisjointSets sets(neighbours.Count());
  for (int cell = 0; cell < neighbours.Count(); ++cell)
  {
    for (int side = 1; side < 6; side += 2)
    {
      if (neighbours.Across(cell, side) >= 0 && !walls[cell][side])
      {
        sets.Merge(cell, neighbours.Across(cell, side));
      }
    }
  }
  std::vector<int> blockOf(neighbours.Count(), -1);
  std::vector<RowVector3i> lowest;
  grid.BlockOf.resize(neighbours.Count());
  for (int cell = 0; cell < neighbours.Count(); ++cell)
  {
    int& block = blockOf[sets.Find(cell)];
    if (block < 0)
    {
      block = static_cast<int>(lowest.size());
      lowest.emplace_back(first.row(cell));
    }
    grid.BlockOf(cell) = block;
    lowest[block] = lowest[block].cwiseMin(first.row(cell));
  }
  grid.Blocks = static_cast<int>(lowest.size());
  grid.Indices.resize(neighbours.Count(), 3);
  for (int cell = 0; cell < neighbours.Count(); ++cell)
  {
    grid.Indices.row(cell) = first.row(cell) - lowest[grid.BlockOf(cell)];
  }
}

} // namespace

HexGrid FindHexGrid(
  const HexFit& fit, const Eigen::MatrixXd& positions, double cellSize, const Progress& progress)
{
  HexGrid grid;
  grid.Cells = fit.Core;
  grid.SourcePositions = Eigen::MatrixXd::Zero(fit.Solid.Points.rows(), 3);
  if (positions.rows() > 0)
  {
    grid.SourcePositions.topRows(positions.rows()) = positions;
  }
  else
  {
    grid.SourcePositions = cellSize * PlaceCells(fit.Core, fit.Solid, cellSize, progress);
  }
  Eigen::MatrixXi first(grid.Cells.rows(), 3);
  for (Eigen::Index cell = 0; cell < grid.Cells.rows(); ++cell)
  {
    const Eigen::MatrixXd corners = grid.SourcePositions(grid.Cells.row(cell), Eigen::all);
    first.row(cell) = (corners.colwise().minCoeff() / cellSize).array().round().cast<int>();
  }
  progress(0.0);
  FindBlocks(first, grid);
  progress(0.0);
  PlaceLayers(fit, grid.SourcePositions, progress);
  return grid;
}

} // namespace shape
