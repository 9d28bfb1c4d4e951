#include "Hex/HexRemesh.h"
#include "Mesh/HexMesh.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>
#include <vector>

namespace
{

using MethodType = shape::HexRemeshOptions::MethodType;

shape::HexRemeshResult Remesh(const shape::Mesh& surface, MethodType method, double cellSize)
{
  shape::HexRemeshOptions options;
  options.Method = method;
  options.CellSize = cellSize;
  return shape::RemeshHexahedra(surface, options);
}

/// Every cell is a cube of this size, and every block is a box that its cells fill once.
void ExpectRegular(const shape::HexGrid& grid, double size)
{
  std::vector<std::set<std::tuple<int, int, int>>> indices(grid.Blocks);
  std::vector<Eigen::RowVector3i> counts(grid.Blocks, Eigen::RowVector3i::Zero());
  std::vector<Eigen::RowVector3d> origins(grid.Blocks, Eigen::RowVector3d::Constant(1e300));
  for (Eigen::Index cell = 0; cell < grid.Cells.rows(); ++cell)
  {
    const Eigen::MatrixXd corners = grid.SourcePositions(grid.Cells.row(cell), Eigen::all);
    const Eigen::RowVector3d low = corners.colwise().minCoeff();
    ASSERT_LT((corners.colwise().maxCoeff() - low).array().abs().maxCoeff() - size, 1e-9);
    const int block = grid.BlockOf(cell);
    const Eigen::RowVector3i at = grid.Indices.row(cell);
    indices[block].emplace(at(0), at(1), at(2));
    counts[block] = counts[block].cwiseMax(at + Eigen::RowVector3i::Ones());
    const Eigen::RowVector3d origin = low - size * at.cast<double>();
    if (indices[block].size() == 1)
    {
      origins[block] = origin;
    }
    EXPECT_LT((origin - origins[block]).cwiseAbs().maxCoeff(), 1e-9);
  }
  std::size_t cells = 0;
  for (int block = 0; block < grid.Blocks; ++block)
  {
    EXPECT_EQ(static_cast<int>(indices[block].size()), counts[block].prod());
    cells += indices[block].size();
  }
  EXPECT_EQ(static_cast<Eigen::Index>(cells), grid.Cells.rows());
}

/// Points of layers lie between points of the grid.
void ExpectInside(const shape::HexRemeshResult& result)
{
  std::set<int> inGrid(result.Grid.Cells.reshaped().begin(), result.Grid.Cells.reshaped().end());
  const std::vector<int> used(inGrid.begin(), inGrid.end());
  const Eigen::MatrixXd& all = result.Grid.SourcePositions;
  const Eigen::MatrixXd own = all(used, Eigen::all);
  EXPECT_LT(own.rows(), all.rows());
  EXPECT_TRUE((all.colwise().minCoeff().array() >= own.colwise().minCoeff().array() - 1e-9).all());
  EXPECT_TRUE((all.colwise().maxCoeff().array() <= own.colwise().maxCoeff().array() + 1e-9).all());
  EXPECT_TRUE(all.allFinite());
}

} // namespace

TEST(HexGrid, ABoxIsOneBlock)
{
  const shape::HexRemeshResult result =
    Remesh(shapetest::Box({ 0.0, 0.0, 0.0 }, { 1.0, 2.0, 1.5 }), MethodType::Grid, 0.25);
  EXPECT_EQ(result.Grid.Blocks, 1);
  ExpectRegular(result.Grid, result.CellSize);
  ExpectInside(result);
}

TEST(HexGrid, AnLIsThreeBlocksByEveryMethod)
{
  // The walls at its inner corner divide it into the corner and two legs.
  const shape::Mesh bracket = shapetest::Prism(
    { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 }, { 1.0, 2.0 }, { 0.0, 2.0 } });
  for (const MethodType method : { MethodType::Grid, MethodType::Polycube })
  {
    const shape::HexRemeshResult result = Remesh(bracket, method, 0.25);
    EXPECT_EQ(result.Grid.Blocks, 3);
    ExpectRegular(result.Grid, result.CellSize);
    ExpectInside(result);
    // Points of the grid's boundary are on the boundary of the hexahedra.
    const Eigen::MatrixXi sides = shape::FindBoundaryQuads({ {}, result.Grid.Cells });
    const std::set<int> outer(
      result.Fit.Quads.reshaped().begin(), result.Fit.Quads.reshaped().end());
    for (const int point : sides.reshaped())
    {
      EXPECT_TRUE(outer.count(point) == 1);
    }
  }
}

TEST(HexGrid, GridsOfSeparateSolidsAreApart)
{
  const shape::Mesh small = shapetest::Box({ 1.1, 0.0, 0.0 }, { 1.4, 0.3, 0.3 }),
                    large = shapetest::Box({ 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 });
  const shape::HexRemeshResult result =
    Remesh(shapetest::Joined({ large, small }), MethodType::Grid, 0.2);
  EXPECT_EQ(result.Grid.Blocks, 2);
  ExpectRegular(result.Grid, result.CellSize);
  std::set<std::tuple<long, long, long>> places;
  for (Eigen::Index cell = 0; cell < result.Grid.Cells.rows(); ++cell)
  {
    const Eigen::RowVector3d centre =
      result.Grid.SourcePositions(result.Grid.Cells.row(cell), Eigen::all).colwise().mean() /
      result.CellSize;
    EXPECT_TRUE(places
                  .emplace(std::lround(2.0 * centre(0)), std::lround(2.0 * centre(1)),
                    std::lround(2.0 * centre(2)))
                  .second);
  }
}

TEST(HexGrid, AWallLiesAcrossTheEndOfASlit)
{
  // Two layers of three cells; the first cells of both touch, but are not connected.
  shape::HexFit fit;
  fit.Solid.Points.resize(26, 3);
  for (int i = 0; i < 24; ++i)
  {
    fit.Solid.Points.row(i) << i % 4, i / 4 % 2, i / 8;
  }
  fit.Solid.Points.row(24) << 0, 0, 1;
  fit.Solid.Points.row(25) << 0, 1, 1;
  fit.Solid.Hexahedra.resize(6, 8);
  for (int cell = 0; cell < 6; ++cell)
  {
    const int first = cell % 3 + 8 * (cell / 3);
    fit.Solid.Hexahedra.row(cell) << first, first + 1, first + 5, first + 4, first + 8, first + 9,
      first + 13, first + 12;
  }
  fit.Solid.Hexahedra(3, 0) = 24;
  fit.Solid.Hexahedra(3, 3) = 25;
  fit.Core = fit.Solid.Hexahedra;
  fit.Quads = shape::FindBoundaryQuads(fit.Solid);
  const shape::HexGrid grid = shape::FindHexGrid(fit, fit.Solid.Points, 1.0);
  // A side of a block is thus not partly a side of another block and partly on the boundary.
  EXPECT_EQ(grid.Blocks, 4);
  ExpectRegular(grid, 1.0);
  for (const int first : { 0, 3 })
  {
    EXPECT_NE(grid.BlockOf(first), grid.BlockOf(first + 1));
    EXPECT_EQ(grid.BlockOf(first + 1), grid.BlockOf(first + 2));
  }
}
