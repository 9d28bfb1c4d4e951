#include "Geodesics/HeatGeodesics.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Laplacian/Private/TuftedCover.h"
#include "Mesh/HalfEdges.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// Three unit squares of `cells` x `cells` that meet along one side, 120 degrees apart.
shape::Mesh ThreePages(int cells)
{
  const int row = cells + 1, page = row * cells; // the points of the side come first
  shape::Mesh mesh{ Eigen::MatrixXd(row + 3 * page, 3), Eigen::MatrixXi(6 * cells * cells, 3) };
  const auto id = [&](int sheet, int x, int y)
  { return x == 0 ? y : row + sheet * page + (x - 1) * row + y; };
  int t = 0;
  for (int sheet = 0; sheet < 3; ++sheet)
  {
    const double angle = 2.0 * M_PI * sheet / 3.0;
    for (int x = 0; x <= cells; ++x)
    {
      for (int y = 0; y <= cells; ++y)
      {
        const double out = static_cast<double>(x) / cells;
        mesh.Points.row(id(sheet, x, y)) << out * std::cos(angle), out * std::sin(angle),
          static_cast<double>(y) / cells;
        if (x < cells && y < cells)
        {
          mesh.Triangles.row(t++) << id(sheet, x, y), id(sheet, x + 1, y), id(sheet, x, y + 1);
          mesh.Triangles.row(t++) << id(sheet, x + 1, y), id(sheet, x + 1, y + 1),
            id(sheet, x, y + 1);
        }
      }
    }
  }
  return mesh;
}

} // namespace

TEST(TuftedCover, IsAClosedOrientedManifold)
{
  const shape::Mesh pages = ThreePages(4);
  ASSERT_FALSE(shape::AreEdgesManifold(shape::SortHalfEdges(pages.Triangles, pages.Points.rows())));
  const shape::GluedTriangles cover = shape::BuildTuftedCover(pages);
  ASSERT_EQ(cover.Triangles.rows(), 2 * pages.Triangles.rows());
  for (int side = 0; side < static_cast<int>(cover.Twins.size()); ++side)
  {
    const int twin = cover.Twins[side];
    ASSERT_EQ(cover.Twins[twin], side);
    ASSERT_NE(twin, side);
    EXPECT_EQ(cover.Triangles(side / 3, side % 3), cover.Triangles(twin / 3, (twin + 1) % 3));
    EXPECT_EQ(cover.Triangles(side / 3, (side + 1) % 3), cover.Triangles(twin / 3, twin % 3));
  }
}

// Of a closed manifold, the cover is two copies: the Laplacian is the same.
TEST(TuftedCover, OfASphereHasItsLaplacian)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const shape::GluedTriangles cover = shape::BuildTuftedCover(sphere);
  const std::vector<int> twins =
    shape::FindTwins(sphere.Triangles, static_cast<Eigen::Index>(sphere.Points.rows()));
  for (std::size_t side = 0; side < twins.size(); ++side)
  {
    EXPECT_EQ(cover.Twins[side], twins[side]);
  }
}

// Linear functions along the common side are harmonic, and the masses are the areas.
TEST(TuftedCover, LaplacianOfThreePages)
{
  constexpr int cells = 6;
  const shape::Surface pages = ThreePages(cells);
  const auto laplacian = shape::GetIntrinsicLaplacian(pages);
  EXPECT_EQ(laplacian->Copies, 2);
  EXPECT_NEAR(laplacian->Masses.sum(), 3.0, 1e-4);
  EXPECT_GT(laplacian->Masses.minCoeff(), 0.0);
  const Eigen::VectorXd height = pages.Points().col(2);
  const Eigen::VectorXd out = pages.Points().leftCols(2).rowwise().norm();
  // The Dirichlet energy of a function with gradient 1 is half the area, and functions with
  // gradients at right angles are orthogonal.
  EXPECT_NEAR(height.dot(laplacian->Stiffness * height), 3.0, 1e-4);
  EXPECT_NEAR(out.dot(laplacian->Stiffness * out), 3.0, 1e-4);
  EXPECT_NEAR(out.dot(laplacian->Stiffness * height), 0.0, 1e-4);
  EXPECT_LE((laplacian->Stiffness * Eigen::VectorXd::Ones(height.size())).norm(), 1e-9);
}

// Distances continue across the common side into both other pages.
TEST(TuftedCover, HeatCrossesTheCommonSide)
{
  constexpr int cells = 24;
  const shape::Surface pages = ThreePages(cells);
  Eigen::VectorXd seeds = Eigen::VectorXd::Zero(pages.Points().rows());
  int seed = 0;
  for (int i = 0; i < pages.Points().rows(); ++i)
  {
    // The middle of the outer side of the first page.
    if (pages.Points()(i, 0) > pages.Points()(seed, 0) - 1e-12 &&
      std::abs(pages.Points()(i, 2) - 0.5) < 1e-12)
    {
      seed = i;
    }
  }
  seeds(seed) = 1.0;
  const Eigen::VectorXd distances =
    shape::GetHeatGeodesics(pages)->Distances(Eigen::MatrixXd(seeds));
  for (int i = 0; i < pages.Points().rows(); ++i)
  {
    const Eigen::RowVector3d p = pages.Points().row(i);
    const double out = p.head(2).norm();
    const bool isFirst = p(0) > 0.0 && std::abs(p(1)) < 1e-9;
    const double flat = std::hypot(isFirst ? 1.0 - out : 1.0 + out, p(2) - 0.5);
    EXPECT_NEAR(distances(i), flat, 0.06) << p;
  }
}
