#include "Base/Errors.h"
#include "Correspondence/Conformal/OrbifoldMap.h"
#include "Support/MatchingShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using shape::OrbifoldType;

namespace
{

constexpr OrbifoldType AllTypes[] = { OrbifoldType::Square, OrbifoldType::Rhombus,
  OrbifoldType::Triangle, OrbifoldType::Rectangle };

std::vector<int> Cones(OrbifoldType type)
{
  return shape::GetConeCount(type) == 3 ? std::vector<int>{ 0, 4, 8 }
                                        : std::vector<int>{ 0, 4, 8, 2 };
}

/// Positions on a surface where a map sends points.
Eigen::MatrixXd Positions(const shape::SurfacePoints& map, const shape::Mesh& target)
{
  return shape::PullBack(map, target.Triangles, target.Points);
}

} // namespace

TEST(OrbifoldMap, ASurfaceAndItsRotatedCopyGiveTheIdentity)
{
  const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(3));
  shape::Mesh b = a;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.0, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  b.Points = a.Points * turn.transpose();
  for (const OrbifoldType type : AllTypes)
  {
    const shape::OrbifoldMap map = shape::MapThroughOrbifold(a, Cones(type), b, Cones(type), type);
    EXPECT_LT((Positions(map.AToB, b) - b.Points).cwiseAbs().maxCoeff(), 1e-7);
    EXPECT_LT((Positions(map.BToA, a) - a.Points).cwiseAbs().maxCoeff(), 1e-7);
  }
}

TEST(OrbifoldMap, AnotherMeshOfTheSameShapeGivesNearlyTheIdentity)
{
  // Other triangles, other cuts; the maps to the tile have the same limit. Near a cone of order k
  // the image grows with the k-th root of the distance, so that errors fall with h^(2 / k).
  const double limits[] = { 0.04, 0.02, 0.07, 0.02 };
  for (const OrbifoldType type : AllTypes)
  {
    double before = 1.0;
    for (const int level : { 2, 3, 4 })
    {
      const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(level));
      const shape::Mesh b = shapetest::Pebble(shapetest::Icosphere(level + 1));
      const shape::OrbifoldMap map =
        shape::MapThroughOrbifold(a, Cones(type), b, Cones(type), type);
      // The first points of the finer mesh are those of the coarser one.
      const double error =
        (Positions(map.AToB, b) - b.Points.topRows(a.Points.rows())).rowwise().norm().mean();
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
  for (const OrbifoldType type : AllTypes)
  {
    const std::vector<int>& conesB = conesOfB[shape::GetConeCount(type) - 3];
    const shape::OrbifoldMap map = shape::MapThroughOrbifold(a, Cones(type), b, conesB, type);
    for (std::size_t i = 0; i < conesB.size(); ++i)
    {
      const int cone = Cones(type)[i];
      Eigen::Index corner = 0;
      EXPECT_EQ(map.AToB.Barycentrics.row(cone).maxCoeff(&corner), 1.0);
      EXPECT_EQ(b.Triangles(map.AToB.Triangles(cone), corner), conesB[i]);
    }
    EXPECT_TRUE((map.AToB.Barycentrics.array() >= 0.0).all());
    // There and back: the place on B of each point of A, found on A again.
    const auto imageA = shape::MapToOrbifold(a, Cones(type), type);
    const auto imageB = shape::MapToOrbifold(b, conesB, type);
    const Eigen::MatrixXd positions =
      shape::PullBack(map.AToB, imageB.Cut.Surface.Triangles, imageB.Points);
    const shape::OrbifoldLocator locator(imageA, 20.0);
    EXPECT_LT((Positions(locator.Find(positions), a) - a.Points).cwiseAbs().maxCoeff(), 1e-6);
    // The image of A on B winds around its inside once, facing outwards.
    const Eigen::MatrixXd onB = Positions(map.AToB, b);
    EXPECT_NEAR(shape::ComputeWindingNumber(onB, a.Triangles, Eigen::RowVector3d(0.01, 0.02, 0.03)),
      1.0, 1e-9);
  }
}

TEST(OrbifoldMap, APlaceIsFoundWhereverItsImageUnderTheGroupLies)
{
  const shape::Mesh mesh = shapetest::Pebble(shapetest::Icosphere(2));
  for (const OrbifoldType type : AllTypes)
  {
    const auto image = shape::MapToOrbifold(mesh, Cones(type), type);
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
      EXPECT_LT((Positions(locator.Find(moved), mesh) - mesh.Points).cwiseAbs().maxCoeff(), 1e-7);
    }
    EXPECT_THROW(locator.Find(Eigen::MatrixXd::Constant(1, 2, 9.0)), shape::InvalidInput);
  }
}

TEST(OrbifoldMap, SaysWhichSurfaceIsAtFault)
{
  try
  {
    shape::MapThroughOrbifold(shapetest::Icosphere(1), { 0, 4, 8 },
      shapetest::Torus(1.0, 0.3, 12, 8), { 0, 4, 8 }, OrbifoldType::Square);
    FAIL() << "a torus";
  }
  catch (const shape::InvalidInput& error)
  {
    EXPECT_EQ(std::string(error.what()).find("Surface B: "), 0u) << error.what();
  }
}
