#include "Base/Errors.h"
#include "Correspondence/Conformal/OrbifoldMap.h"
#include "Support/MatchingShapes.h"
#include "Support/Orbifolds.h"
#include "Support/Refusals.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using shape::OrbifoldType;
using shapetest::ConesOnIcosphere;
using shapetest::PositionsOn;

TEST(OrbifoldMap, ASurfaceAndItsRotatedCopyGiveTheIdentity)
{
  const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(3));
  shape::Mesh b = a;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.0, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  b.Points = a.Points * turn.transpose();
  for (const OrbifoldType type : shapetest::AllOrbifolds)
  {
    const shape::OrbifoldMap map =
      shape::MapThroughOrbifold(a, ConesOnIcosphere(type), b, ConesOnIcosphere(type), type);
    EXPECT_LT((PositionsOn(map.AToB, b) - b.Points).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT((PositionsOn(map.BToA, a) - a.Points).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST(OrbifoldMap, AnotherMeshOfTheSameShapeGivesNearlyTheIdentity)
{
  // Other triangles, other cuts; the maps to the tile have the same limit. Near a cone of order k
  // the image grows with the k-th root of the distance, so that errors fall with h^(2 / k).
  const double limits[] = { 0.04, 0.02, 0.07, 0.02 };
  for (const OrbifoldType type : shapetest::AllOrbifolds)
  {
    double before = 1.0;
    for (const int level : { 2, 3, 4 })
    {
      const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(level));
      const shape::Mesh b = shapetest::Pebble(shapetest::Icosphere(level + 1));
      const shape::OrbifoldMap map =
        shape::MapThroughOrbifold(a, ConesOnIcosphere(type), b, ConesOnIcosphere(type), type);
      // The first points of the finer mesh are those of the coarser one.
      const double error =
        (PositionsOn(map.AToB, b) - b.Points.topRows(a.Points.rows())).rowwise().norm().mean();
      EXPECT_LT(error, 0.9 * before) << static_cast<int>(type) << " level " << level;
      before = error;
    }
    EXPECT_LT(before, limits[static_cast<int>(type)]) << static_cast<int>(type);
  }
}

TEST(OrbifoldMap, IsOneToOneKeepsOrientationAndMeetsTheCones)
{
  const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(3));
  shape::Mesh b = shapetest::Icosphere(3);
  b.Points.col(2) *= 2.0;
  const std::vector<std::vector<int>> conesOfB = { { 3, 9, 5 }, { 5, 7, 2, 10 } };
  for (const OrbifoldType type : shapetest::AllOrbifolds)
  {
    const std::vector<int>& conesB = conesOfB[shape::GetConeCount(type) - 3];
    const shape::OrbifoldMap map =
      shape::MapThroughOrbifold(a, ConesOnIcosphere(type), b, conesB, type);
    for (std::size_t i = 0; i < conesB.size(); ++i)
    {
      const int cone = ConesOnIcosphere(type)[i];
      Eigen::Index corner = 0;
      EXPECT_EQ(map.AToB.Barycentrics.row(cone).maxCoeff(&corner), 1.0);
      EXPECT_EQ(b.Triangles(map.AToB.Triangles(cone), corner), conesB[i]);
    }
    EXPECT_TRUE((map.AToB.Barycentrics.array() >= 0.0).all());
    // There and back: the place on B of each point of A, found on A again.
    const auto imageA = shape::MapToOrbifold(a, ConesOnIcosphere(type), type);
    const auto imageB = shape::MapToOrbifold(b, conesB, type);
    const Eigen::MatrixXd positions =
      shape::PullBack(map.AToB, imageB.Cut.Surface.Triangles, imageB.Points);
    const shape::OrbifoldLocator locator(imageA, 20.0);
    EXPECT_LT((PositionsOn(locator.Find(positions), a) - a.Points).cwiseAbs().maxCoeff(), 1e-6);
    // The image of A on B winds around its inside once, facing outwards.
    const Eigen::MatrixXd onB = PositionsOn(map.AToB, b);
    EXPECT_NEAR(shape::ComputeWindingNumber(onB, a.Triangles, Eigen::RowVector3d(0.01, 0.02, 0.03)),
      1.0, 1e-9);
  }
}

TEST(OrbifoldMap, APlaceIsFoundWhereverItsImageUnderTheGroupLies)
{
  const shape::Mesh mesh = shapetest::Pebble(shapetest::Icosphere(2));
  for (const OrbifoldType type : shapetest::AllOrbifolds)
  {
    const auto image = shape::MapToOrbifold(mesh, ConesOnIcosphere(type), type);
    const shape::OrbifoldLocator locator(image, 8.0);
    const Eigen::MatrixXd own = image.Points.topRows(mesh.Points.rows());
    for (const shape::PlaneIsometry& motion : shape::ComputeOrbifoldMotions(image.Tile, 0.0, 3.0))
    {
      Eigen::MatrixXd moved(own.rows(), 2);
      for (Eigen::Index i = 0; i < own.rows(); ++i)
      {
        const std::complex<double> z = motion({ own(i, 0), own(i, 1) });
        moved.row(i) << z.real(), z.imag();
      }
      EXPECT_LT((PositionsOn(locator.Find(moved), mesh) - mesh.Points).cwiseAbs().maxCoeff(), 1e-7);
    }
    EXPECT_THROW(locator.Find(Eigen::MatrixXd::Constant(1, 2, 9.0)), shape::InvalidInput);
  }
}

TEST(OrbifoldMap, SaysWhichSurfaceIsAtFault)
{
  const std::string refusal = shapetest::Refusal(
    []
    {
      shape::MapThroughOrbifold(shapetest::Icosphere(1), { 0, 4, 8 },
        shapetest::Torus(1.0, 0.3, 12, 8), { 0, 4, 8 }, OrbifoldType::Square);
    });
  EXPECT_EQ(refusal.find("Surface B: "), 0u) << refusal;
}
