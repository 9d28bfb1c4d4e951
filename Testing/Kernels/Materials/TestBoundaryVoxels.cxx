#include "Materials/BoundaryVoxels.h"

#include "Materials/ImageValues.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace
{

/// A box that is one hexahedron, between positions in units of voxels.
shape::Cells BoxCell(const Eigen::Array3d& low, const Eigen::Array3d& high)
{
  shape::Cells cells;
  cells.Points.resize(8, 3);
  const int order[8] = { 0, 1, 3, 2, 4, 5, 7, 6 };
  for (int i = 0; i < 8; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      cells.Points(i, axis) = (order[i] >> axis & 1) != 0 ? high(axis) : low(axis);
    }
  }
  cells.Kinds.setConstant(1, shape::cell_kind::Hexahedron);
  cells.Offsets = Eigen::Vector2i(0, 8);
  cells.Corners = Eigen::VectorXi::LinSpaced(8, 0, 7);
  return cells;
}

double LinearDensity(const Eigen::Array3d& x)
{
  return 1.0 + 0.02 * x(0) + 0.01 * x(1) - 0.015 * x(2);
}

/// The means over the boxes of the voxels: a linear field inside a box, 0 outside.
shape::VoxelImage MakePhantom(const Eigen::Array3d& low, const Eigen::Array3d& high)
{
  shape::VoxelImage image;
  image.Size = { 18, 17, 16 };
  image.Channels.emplace_back();
  for (int k = 0; k < 16; ++k)
  {
    for (int j = 0; j < 17; ++j)
    {
      for (int i = 0; i < 18; ++i)
      {
        const Eigen::Array3d at(i, j, k);
        const Eigen::Array3d from = low.max(at - 0.5), to = high.min(at + 0.5);
        const Eigen::Array3d lengths = (to - from).max(0.0);
        image.Channels[0].push_back(lengths.prod() * LinearDensity(0.5 * (from + to)));
      }
    }
  }
  return image;
}

const Eigen::Array3d Low(3.2, 2.7, 4.1), High(13.6, 12.1, 11.9);

} // namespace

TEST(BoundaryVoxels, TheSharesSumUpToTheVolume)
{
  const shape::VoxelImage image = MakePhantom(Low, High);
  std::vector<double> shares;
  shape::AddVoxelShares(BoxCell(Low, High), {}, image, shares);
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), (High - Low).prod(), 1e-6);
  EXPECT_NEAR(shares[image.IndexOf(8, 8, 8)], 1.0, 0.05);
  EXPECT_EQ(shares[image.IndexOf(1, 8, 8)], 0.0);
  // A ghost has no share.
  std::vector<double> none;
  shape::AddVoxelShares(BoxCell(Low, High), Eigen::VectorXi::Zero(1), image, none);
  EXPECT_EQ(*std::max_element(none.begin(), none.end()), 0.0);
}

// Without the partial volume, the linear field is restored everywhere in the solid.
TEST(BoundaryVoxels, ALinearFieldIsRestoredAtTheBoundary)
{
  const shape::VoxelImage image = MakePhantom(Low, High);
  const Eigen::Array3d thin(High(0), High(1), Low(2) + 1.0);
  for (const shape::Cells& cell : { BoxCell(Low, High), BoxCell(Low, thin) })
  {
    std::vector<double> shares;
    shape::AddVoxelShares(BoxCell(Low, High), {}, image, shares);
    std::vector<double> values = image.Channels[0];
    const shape::BoundaryVoxels found = shape::ExtrapolateToBoundary(image, shares, 1, values);
    EXPECT_EQ(found.Unresolved, 0);
    EXPECT_GT(found.Raised, 100);
    const auto identity = [](double v) { return v; };
    const auto density = [&](const std::vector<double>& given) {
      return shape::ComputeImageValues(cell, image, { given, identity, identity }).Density(0);
    };
    const Eigen::Array3d centre =
      0.5 * (cell.Points.row(0) + cell.Points.row(6)).transpose().array();
    EXPECT_NEAR(density(values), LinearDensity(centre), 1e-12);
    EXPECT_LT(density(image.Channels[0]), 0.97 * LinearDensity(centre));
  }
}

TEST(BoundaryVoxels, NoValueIsLoweredAndNoLayerChangesNothing)
{
  const shape::VoxelImage image = MakePhantom(Low, High);
  std::vector<double> shares;
  shape::AddVoxelShares(BoxCell(Low, High), {}, image, shares);
  for (const int layers : { 0, 1, 2, 40 })
  {
    std::vector<double> values = image.Channels[0];
    const shape::BoundaryVoxels found = shape::ExtrapolateToBoundary(image, shares, layers, values);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      EXPECT_GE(values[i], image.Channels[0][i]);
    }
    if (layers == 0 || layers == 40)
    {
      // With 40 layers, no voxel is an inner one.
      EXPECT_EQ(values, image.Channels[0]);
      EXPECT_EQ(found.Unresolved, found.Boundary);
    }
  }
}

// A mesh that goes on beyond the image has no boundary there.
TEST(BoundaryVoxels, TheEndOfTheImageIsNoBoundary)
{
  shape::VoxelImage image;
  image.Size = { 6, 6, 6 };
  std::vector<double> shares, values(image.Count(), 1.0);
  shape::AddVoxelShares(BoxCell({ -9.0, -9.0, -9.0 }, { 20.0, 20.0, 20.0 }), {}, image, shares);
  EXPECT_EQ(shape::ExtrapolateToBoundary(image, shares, 1, values).Boundary, 0);
  shares.clear();
  shape::AddVoxelShares(BoxCell({ 0.0, -9.0, -9.0 }, { 20.0, 20.0, 20.0 }), {}, image, shares);
  EXPECT_EQ(shape::ExtrapolateToBoundary(image, shares, 1, values).Boundary, 36);
}
