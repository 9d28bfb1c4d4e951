#include "Search/ClosestPoint.h"
#include "Support/TestShapes.h"
#include "Transfer/TextureSeams.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// A cylinder of radius 1 that is cut along its length at the angle 0. The texture coordinates are
/// the angle / 2 pi, from 0 to 1, and the height.
struct CutCylinder
{
  shape::Mesh Mesh;
  Eigen::MatrixXd Texture;

  CutCylinder(int around, int up)
    : Mesh{ Eigen::MatrixXd((around + 1) * (up + 1), 3), Eigen::MatrixXi(2 * around * up, 3) }
    , Texture((around + 1) * (up + 1), 2)
  {
    for (int i = 0; i <= around; ++i)
    {
      for (int j = 0; j <= up; ++j)
      {
        const int p = i * (up + 1) + j, q = p + up + 1;
        const double angle = 2.0 * M_PI * (i % around) / around;
        this->Mesh.Points.row(p) << std::cos(angle), std::sin(angle), static_cast<double>(j) / up;
        this->Texture.row(p) << static_cast<double>(i) / around, static_cast<double>(j) / up;
        if (i < around && j < up)
        {
          this->Mesh.Triangles.row(2 * (i * up + j)) << p, q, q + 1;
          this->Mesh.Triangles.row(2 * (i * up + j) + 1) << p, q + 1, p + 1;
        }
      }
    }
  }
};

/// Quadrilaterals around the same cylinder, without a cut, which no point of the giver meets.
std::vector<std::vector<int>> Quads(int around, int up, Eigen::MatrixXd& points)
{
  points.resize(around * (up + 1), 3);
  std::vector<std::vector<int>> quads;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j <= up; ++j)
    {
      const double angle = 2.0 * M_PI * (i + 0.5) / around;
      points.row(i * (up + 1) + j) << std::cos(angle), std::sin(angle),
        0.05 + 0.9 * static_cast<double>(j) / up;
      if (j < up)
      {
        const int p = i * (up + 1) + j, q = (i + 1) % around * (up + 1) + j;
        quads.push_back({ p, q, q + 1, p + 1 });
      }
    }
  }
  return quads;
}

} // namespace

TEST(TextureSeams, NoPolygonInterpolatesAcrossASeam)
{
  const CutCylinder giver(60, 8);
  ASSERT_TRUE(shape::HasSeams(giver.Mesh));
  for (const int around : { 37, 90, 11 })
  {
    Eigen::MatrixXd points;
    const auto quads = Quads(around, 5, points);
    const shape::ClosestPoints closest = shape::SurfaceLocator(giver.Mesh).Find(points);
    Eigen::MatrixXd found(points.rows(), 2);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      found.row(i) = closest.Barycentrics.row(i) *
        giver.Texture(giver.Mesh.Triangles.row(closest.Triangles(i)), Eigen::all);
    }
    const auto split = shape::SplitAtSeams(giver.Mesh, giver.Texture, quads, points, found);
    ASSERT_EQ(split.Polygons.size(), quads.size());
    double before = 0.0, after = 0.0;
    for (std::size_t i = 0; i < quads.size(); ++i)
    {
      const auto widthOf = [](const Eigen::VectorXd& u) { return u.maxCoeff() - u.minCoeff(); };
      before = std::max(before, widthOf(found(quads[i], 0)));
      after = std::max(after, widthOf(split.Texture(split.Polygons[i], 0)));
      for (std::size_t k = 0; k < 4; ++k)
      {
        const int corner = split.Polygons[i][k];
        const int point = corner < points.rows() ? corner : split.Copied[corner - points.rows()];
        EXPECT_EQ(point, quads[i][k]);
        // Along the cylinder there is no seam.
        EXPECT_NEAR(split.Texture(corner, 1), points(point, 2), 1e-9);
      }
    }
    EXPECT_GT(before, 0.9);
    EXPECT_LT(after, 1.0 / around + 1e-3); // the width of a quadrilateral
    // Only the corners along the seam are copied, once each.
    EXPECT_LE(split.Copied.size(), 2U * 6U);
    EXPECT_GE(split.Copied.size(), 6U);
  }
}

TEST(TextureSeams, WithoutASeamNothingIsCopied)
{
  const shape::Surface sphere = shapetest::Icosphere(3);
  EXPECT_FALSE(shape::HasSeams(sphere));
  const shape::Surface disk = shapetest::FlatDisk(6); // open, but no two points coincide
  EXPECT_FALSE(shape::HasSeams(disk));
  std::vector<std::vector<int>> polygons;
  for (const auto& row : disk.Triangles().rowwise())
  {
    polygons.push_back({ row(0), row(1), row(2) });
  }
  const Eigen::MatrixXd texture = disk.Points().leftCols(2);
  const auto split = shape::SplitAtSeams(disk, texture, polygons, disk.Points(), texture);
  EXPECT_TRUE(split.Copied.empty());
  EXPECT_EQ(split.Polygons, polygons);
}
