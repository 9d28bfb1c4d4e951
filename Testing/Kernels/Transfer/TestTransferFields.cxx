#include "Base/Errors.h"
#include "Search/CellLocator.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"
#include "Transfer/TransferFields.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr int Triangle = 5, Polygon = 7, Quad = 9, Tetra = 10, Hexahedron = 12, Wedge = 13;

Eigen::MatrixXd RandomPoints(int count, double low, double high)
{
  std::mt19937_64 generator(5);
  Eigen::MatrixXd points(count, 3);
  for (double& value : points.reshaped())
  {
    value = low + (high - low) * static_cast<double>(generator() >> 11) * 0x1p-53;
  }
  return points;
}

void Append(shape::Cells& cells, int kind, const std::vector<int>& corners)
{
  if (cells.Offsets.size() == 0)
  {
    cells.Offsets = Eigen::VectorXi::Zero(1);
  }
  const Eigen::Index m = cells.Kinds.size(), before = cells.Corners.size();
  cells.Kinds.conservativeResize(m + 1);
  cells.Kinds(m) = kind;
  cells.Corners.conservativeResize(before + static_cast<Eigen::Index>(corners.size()));
  std::copy(corners.begin(), corners.end(), cells.Corners.begin() + before);
  cells.Offsets.conservativeResize(m + 2);
  cells.Offsets(m + 1) = static_cast<int>(cells.Corners.size());
}

/// The unit cube in `side`^3 boxes: hexahedra, or five tetrahedra each, or two wedges each.
shape::Cells Block(int side, int kind)
{
  const int n = side + 1;
  shape::Cells cells;
  cells.Points.resize(n * n * n, 3);
  for (int i = 0; i < n * n * n; ++i)
  {
    cells.Points.row(i) = Eigen::RowVector3d(i % n, i / n % n, i / (n * n)) / side;
  }
  for (int box = 0; box < side * side * side; ++box)
  {
    const int x = box % side, y = box / side % side, z = box / (side * side);
    int c[8];
    for (int k = 0; k < 8; ++k)
    {
      const int across = k & 1, up = k >> 1 & 1, deep = k >> 2;
      c[k] = x + across + n * (y + up + n * (z + deep));
    }
    if (kind == Hexahedron)
    {
      Append(cells, kind, { c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6] });
    }
    else if (kind == Wedge)
    {
      Append(cells, kind, { c[0], c[1], c[2], c[4], c[5], c[6] });
      Append(cells, kind, { c[1], c[3], c[2], c[5], c[7], c[6] });
    }
    else if ((x + y + z) % 2 == 0)
    {
      for (const auto& t : std::vector<std::vector<int>>{
             { 0, 1, 2, 4 }, { 3, 2, 1, 7 }, { 5, 4, 7, 1 }, { 6, 7, 4, 2 }, { 1, 2, 4, 7 } })
      {
        Append(cells, kind, { c[t[0]], c[t[1]], c[t[2]], c[t[3]] });
      }
    }
    else
    {
      for (const auto& t : std::vector<std::vector<int>>{
             { 1, 3, 0, 5 }, { 2, 0, 3, 6 }, { 4, 5, 6, 0 }, { 7, 6, 5, 3 }, { 0, 3, 6, 5 } })
      {
        Append(cells, kind, { c[t[0]], c[t[1]], c[t[2]], c[t[3]] });
      }
    }
  }
  return cells;
}

shape::Cells Surface(const shape::Mesh& mesh)
{
  shape::Cells cells;
  cells.Points = mesh.Points;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    Append(cells, Triangle, { mesh.Triangles(t, 0), mesh.Triangles(t, 1), mesh.Triangles(t, 2) });
  }
  return cells;
}

/// An affine map and its inverse.
struct Affine
{
  Eigen::Matrix3d Linear;
  Eigen::RowVector3d Shift;
  Eigen::MatrixXd operator()(const Eigen::MatrixXd& points) const
  {
    return (points * this->Linear.transpose()).rowwise() + this->Shift;
  }
  Affine Inverse() const
  {
    const Eigen::Matrix3d inverse = this->Linear.inverse();
    return { inverse, -this->Shift * inverse.transpose() };
  }
};

Affine SomeMap()
{
  Affine map;
  map.Linear << 1.2, 0.3, 0.0, -0.1, 0.9, 0.2, 0.0, 0.4, 1.1;
  map.Shift << 3.0, -2.0, 1.0;
  return map;
}

shape::TransferFieldsOptions Push()
{
  shape::TransferFieldsOptions options;
  options.Direction = shape::TransferFieldsOptions::DirectionType::Push;
  return options;
}

} // namespace

TEST(TransferFields, CarriesALinearFieldExactlyBothWays)
{
  // Receivers in the preimage of the giver; a field that is linear in the giver's place.
  const Affine map = SomeMap();
  const Eigen::MatrixXd positions = RandomPoints(2000, 0.0, 1.0);
  const Eigen::MatrixXd receivers = map.Inverse()(positions);
  for (const int kind : { Tetra, Hexahedron, Wedge })
  {
    const shape::Cells giver = Block(4, kind);
    const shape::TransferWeights pulled = shape::TransferFields(giver).Find(map(receivers));
    const shape::TransferWeights pushed =
      shape::TransferFields(giver, map.Inverse()(giver.Points), Push()).Find(receivers);
    for (const shape::TransferWeights& found : { pulled, pushed })
    {
      EXPECT_LT((found.Weights * giver.Points - positions).cwiseAbs().maxCoeff(), 1e-12) << kind;
      EXPECT_EQ(found.Outside.sum(), 0);
      // The corner of most weight is the closest one in a box of equal sides.
      for (Eigen::Index i = 0; kind == Hexahedron && i < positions.rows(); ++i)
      {
        int nearest = 0;
        Eigen::RowVectorXd(found.Weights.row(i)).maxCoeff(&nearest);
        EXPECT_LE(
          (giver.Points.row(nearest) - positions.row(i)).cwiseAbs().maxCoeff(), 0.125 + 1e-12);
      }
    }
  }
}

TEST(TransferFields, FindsTheCellThatContainsThePlace)
{
  const Eigen::MatrixXd positions = RandomPoints(1000, 0.0, 1.0);
  const shape::TransferWeights hexahedra =
    shape::TransferFields(Block(5, Hexahedron)).Find(positions);
  const shape::TransferWeights wedges = shape::TransferFields(Block(5, Wedge)).Find(positions);
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    const Eigen::Array3d scaled = 5.0 * positions.row(i).transpose().array();
    const Eigen::Array3i box = scaled.floor().cast<int>();
    const int number = box(0) + 5 * (box(1) + 5 * box(2));
    const Eigen::Array3d within = scaled - box.cast<double>();
    EXPECT_EQ(hexahedra.Cells(i), number);
    EXPECT_EQ(wedges.Cells(i), 2 * number + (within(0) + within(1) > 1.0));
  }
}

TEST(TransferFields, InvertsATrilinearCell)
{
  // One warped hexahedron: the place of parameters (r, s, t) must get the weights of (r, s, t).
  shape::Cells cell = Block(1, Hexahedron);
  cell.Points += 0.2 * RandomPoints(8, -1.0, 1.0);
  const Eigen::MatrixXd parameters = RandomPoints(500, 0.02, 0.98);
  Eigen::MatrixXd weights(500, 8), positions(500, 3);
  for (Eigen::Index i = 0; i < 500; ++i)
  {
    for (int k = 0; k < 8; ++k)
    {
      weights(i, k) = (k & 1 ? parameters(i, 0) : 1.0 - parameters(i, 0)) *
        (k & 2 ? parameters(i, 1) : 1.0 - parameters(i, 1)) *
        (k & 4 ? parameters(i, 2) : 1.0 - parameters(i, 2));
    }
    positions.row(i) = weights.row(i) * cell.Points;
  }
  const shape::TransferWeights found = shape::TransferFields(cell).Find(positions);
  EXPECT_LT((Eigen::MatrixXd(found.Weights) - weights).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((found.Weights * cell.Points - positions).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(TransferFields, TheOriginIsAPlaceLikeAnyOther)
{
  // Weights that are all 0 interpolate to it.
  shape::Cells voxels;
  voxels.Points.resize(12, 3);
  for (int i = 0; i < 12; ++i)
  {
    voxels.Points.row(i) << i % 3 - 1.5, i / 3 % 2 - 0.5, i / 6 - 0.5;
  }
  Append(voxels, 11, { 0, 1, 3, 4, 6, 7, 9, 10 });
  Append(voxels, 11, { 1, 2, 4, 5, 7, 8, 10, 11 });
  Eigen::MatrixXd positions(2, 3);
  positions << 0, 0, 0, 0.5 + 1e-12, 0.1, 0.2;
  const shape::TransferWeights found = shape::TransferFields(voxels).Find(positions);
  EXPECT_EQ(found.Cells(0), 1);
  EXPECT_NEAR(found.Weights.row(0).sum(), 1.0, 1e-14);
  EXPECT_EQ(found.Weights.row(1).nonZeros(), 8) << "beyond the side by rounding alone";
  EXPECT_LT((found.Weights * voxels.Points - positions).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(TransferFields, OnASurfaceTakesTheClosestPlace)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::MatrixXd directions = RandomPoints(1000, -1.0, 1.0).rowwise().normalized();
  const shape::TransferWeights found = shape::TransferFields(Surface(sphere)).Find(directions);
  EXPECT_EQ(found.Outside.sum(), 0);
  const Eigen::MatrixXd at = found.Weights * sphere.Points;
  EXPECT_LT((at - directions).rowwise().norm().maxCoeff(), 7e-3) << "the facets' sagitta";
  // Polygons are cut into triangles: a field linear in the plane is exact in a pentagon.
  shape::Cells flat;
  flat.Points.resize(7, 3);
  flat.Points << 0, 0, 0, 2, 0, 0, 3, 1, 0, 1, 2, 0, 0, 1, 0, 3, 0, 0, 4, 1, 0;
  Append(flat, Polygon, { 0, 1, 2, 3, 4 });
  Append(flat, Quad, { 1, 5, 6, 2 });
  Eigen::MatrixXd positions(2, 3);
  positions << 1.0, 1.0, 0.0, 2.9, 0.3, 0.0;
  const shape::TransferWeights on = shape::TransferFields(flat).Find(positions);
  EXPECT_LT((on.Weights * flat.Points - positions).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(on.Cells(0), 0);
  EXPECT_EQ(on.Cells(1), 1);
}

TEST(TransferFields, OutsideTakesTheClosestPlaceAndSaysSo)
{
  for (const int kind : { Tetra, Hexahedron, Wedge })
  {
    const shape::Cells giver = Block(3, kind);
    const Eigen::MatrixXd positions = RandomPoints(1000, -1.0, 2.0);
    const shape::TransferWeights found = shape::TransferFields(giver).Find(positions);
    const Eigen::MatrixXd closest = positions.cwiseMax(0.0).cwiseMin(1.0);
    const Eigen::MatrixXd at = found.Weights * giver.Points;
    EXPECT_LT((at - closest).cwiseAbs().maxCoeff(), 1e-12) << kind;
    const Eigen::VectorXd beyond = (positions - closest).rowwise().norm();
    EXPECT_EQ((beyond.array() > 0.01).count(), found.Outside.sum());
    EXPECT_GT(found.Outside.sum(), 900);
  }
  shape::TransferFieldsOptions wide;
  wide.Tolerance = 10.0;
  EXPECT_EQ(shape::TransferFields(Block(1, Tetra), {}, wide)
              .Find(RandomPoints(50, -1.0, 2.0))
              .Outside.sum(),
    0);
}

TEST(TransferFields, RefusesWhatHasNoInterpolant)
{
  shape::Cells lines;
  lines.Points = RandomPoints(4, 0.0, 1.0);
  Append(lines, 3, { 0, 1 });
  EXPECT_REFUSED(shape::TransferFields(lines), "no polygon and no solid cell");
  Append(lines, 42, { 0, 1, 2, 3 });
  EXPECT_REFUSED(shape::TransferFields(lines), "cell 1 is a polyhedron");
  shape::Cells spoiled = Block(2, Tetra);
  spoiled.Points(3, 0) = std::numeric_limits<double>::infinity();
  EXPECT_REFUSED(shape::TransferFields(spoiled), "first at point 3");
  EXPECT_THROW(shape::TransferFields(Block(2, Tetra)).Find(spoiled.Points), shape::InvalidInput);
  EXPECT_THROW(shape::TransferFields(Block(2, Tetra), spoiled.Points, Push()), shape::InvalidInput);
  EXPECT_THROW(shape::TransferFields(Block(2, Tetra)).Find(Eigen::MatrixXd::Constant(1, 3, 1e200)),
    shape::InvalidInput);
}

TEST(TransferFields, ACellWithoutVolumeLeavesNothingUndefined)
{
  shape::Cells flat = Block(1, Tetra);
  flat.Points.col(2).setZero();
  const Eigen::MatrixXd positions = RandomPoints(100, 0.0, 1.0);
  const shape::TransferWeights found = shape::TransferFields(flat).Find(positions);
  EXPECT_TRUE((found.Weights * flat.Points).allFinite());
  EXPECT_NEAR((found.Weights * Eigen::VectorXd::Ones(8)).minCoeff(), 1.0, 1e-6);
}
