#include "Base/Errors.h"
#include "Harmonic/ApplyVolumeMap.h"
#include "Harmonic/PiecewiseInverseMap.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

using shapetest::Sphere;

/// A ball of radius 2 in which a ball of radius 1 has a map of its own: outside it, a charge at the
/// origin shifts places by push / |y|, inside, by `push`. They agree on the sphere between, so on
/// the facets that stand for it to its sagitta.
shape::PiecewiseCharges Nested(double push, double skin)
{
  shape::PiecewiseCharges charges;
  charges.Maps.resize(2);
  charges.Maps[0].Points = Eigen::RowVector3d::Zero();
  charges.Maps[0].Charges = 4.0 * M_PI * push * Eigen::RowVector3d::UnitX();
  charges.Maps[1].Affine(0, 3) = push;
  const shape::Mesh outer = Sphere(3, 2.0), inner = Sphere(3, 1.0);
  charges.Surface = shapetest::Joined({ outer, inner });
  charges.Regions.resize(charges.Surface.Triangles().rows());
  charges.Regions << Eigen::VectorXi::Zero(outer.Triangles.rows()),
    Eigen::VectorXi::Ones(inner.Triangles.rows());
  charges.Farthest = 0.1;
  charges.Skins = Eigen::Vector2d(0.0, skin);
  return charges;
}

/// On every facet of the border, `height` above it.
Eigen::MatrixXd OnBoundary(double height)
{
  const shape::Mesh inner = Sphere(3, 1.0);
  return shape::ComputeCentroids(inner) +
    height * shape::ComputeAreaVectors(inner).rowwise().normalized();
}

} // namespace

TEST(PiecewiseHarmonicMap, EachRegionHasItsOwnMap)
{
  const shape::PiecewiseHarmonicMap map(Nested(0.3, 0.0));
  const Eigen::MatrixXd unit = shapetest::Icosphere(2).Points;
  Eigen::MatrixXd positions(2 * unit.rows(), 3);
  positions << 0.9 * unit, 1.5 * unit;
  const Eigen::VectorXi regions = map.RegionsAt(positions);
  EXPECT_EQ(regions.head(unit.rows()).minCoeff(), 1);
  EXPECT_EQ(regions.tail(unit.rows()).maxCoeff(), 0);
  Eigen::MatrixXd expected = positions;
  expected.col(0).head(unit.rows()).array() += 0.3;
  expected.col(0).tail(unit.rows()).array() += 0.3 / 1.5;
  EXPECT_LT((map.Evaluate(positions) - expected).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_EQ(shape::ApplyVolumeMap(map, positions).OutsideDomain.sum(), 0);
  EXPECT_EQ(shape::ApplyVolumeMap(map, 2.0 * positions).OutsideDomain.sum(), unit.rows());
}

TEST(PiecewiseHarmonicMap, TheSkinMakesItContinuousWithItsDerivative)
{
  for (const double skin : { 0.0, 0.02 })
  {
    const shape::PiecewiseHarmonicMap map(Nested(0.3, skin));
    const Eigen::MatrixXd step = map.Evaluate(OnBoundary(1e-9)) - map.Evaluate(OnBoundary(-1e-9));
    const Eigen::MatrixXd turn = map.Jacobians(OnBoundary(1e-9)) - map.Jacobians(OnBoundary(-1e-9));
    // 1 / |y| - 1 at the facets' middles, without the skin: 0.3 times the sagitta of 2e-3.
    EXPECT_EQ(step.cwiseAbs().maxCoeff() < 1e-8, skin > 0.0) << step.cwiseAbs().maxCoeff();
    EXPECT_EQ(turn.cwiseAbs().maxCoeff() < 1e-5, skin > 0.0) << turn.cwiseAbs().maxCoeff();
  }
}

TEST(PiecewiseHarmonicMap, TheDerivativeIsThatOfTheMapInTheSkinToo)
{
  const shape::PiecewiseHarmonicMap map(Nested(0.3, 0.05));
  const double h = 1e-6;
  int inSkin = 0;
  for (const double height : { -0.2, -0.045, -0.03, -0.01, -0.001, 0.1 })
  {
    const Eigen::MatrixXd positions = OnBoundary(height);
    inSkin += static_cast<int>((map.Locate(positions).Shares.array() > 0.0).count());
    const Eigen::MatrixXd jacobians = map.Jacobians(positions);
    for (int c = 0; c < 3; ++c)
    {
      const Eigen::RowVector3d step = h * Eigen::RowVector3d::Unit(c);
      const Eigen::MatrixXd difference =
        (map.Evaluate(positions.rowwise() + step) - map.Evaluate(positions.rowwise() - step)) /
        (2.0 * h);
      for (int r = 0; r < 3; ++r)
      {
        EXPECT_LT((jacobians.col(3 * r + c) - difference.col(r)).cwiseAbs().maxCoeff(), 1e-7);
      }
    }
  }
  EXPECT_EQ(inSkin, 4 * Sphere(3, 1.0).Triangles.rows());
}

TEST(PiecewiseHarmonicMap, TheInverseFindsPlacesInEveryRegionAndSkin)
{
  const auto map = std::make_shared<const shape::PiecewiseHarmonicMap>(Nested(0.3, 0.02));
  const shape::PiecewiseInverseMap inverse(map);
  const Eigen::MatrixXd unit = shapetest::Icosphere(2).Points;
  Eigen::MatrixXd positions(5 * unit.rows(), 3);
  positions << 0.3 * unit, 0.97 * unit, 0.985 * unit, 1.01 * unit, 1.9 * unit;
  const Eigen::MatrixXd images = map->Evaluate(positions);
  const auto found = inverse.Find(images);
  EXPECT_EQ(found.States.sum(), 0);
  EXPECT_LT((map->Evaluate(found.Points) - images).rowwise().norm().maxCoeff(), 4e-11);
  EXPECT_LT((found.Points - positions).rowwise().norm().maxCoeff(), 1e-9);
  const auto beyond = inverse.Find(2.0 * images.bottomRows(unit.rows()));
  EXPECT_EQ(beyond.States.sum(), unit.rows());
}

TEST(PiecewiseHarmonicMap, AVoidBelongsToTheRegionAroundIt)
{
  shape::PiecewiseCharges charges = Nested(0.1, 0.0);
  const shape::Mesh hole = Sphere(2, 0.4);
  charges.Surface = shapetest::Joined({ charges.Surface, hole });
  const Eigen::VectorXi before = charges.Regions;
  charges.Regions.resize(charges.Surface.Triangles().rows());
  charges.Regions << before,
    Eigen::VectorXi::Constant(hole.Triangles.rows(), shape::PiecewiseCharges::Void);
  const shape::PiecewiseHarmonicMap map(charges);
  EXPECT_EQ(shape::ApplyVolumeMap(map, Eigen::RowVector3d::Zero()).OutsideDomain(0), 1);
  EXPECT_EQ(shape::ApplyVolumeMap(map, Eigen::RowVector3d(0.6, 0, 0)).OutsideDomain(0), 0);
  const Eigen::Index sphere = Sphere(3, 1.0).Triangles.rows();
  EXPECT_EQ(map.BoundaryOf(0).Triangles.rows(), 2 * sphere);
  EXPECT_EQ(map.BoundaryOf(1).Triangles.rows(), sphere + hole.Triangles.rows());
}

TEST(PiecewiseHarmonicMap, NamesTheRegionThatIsOutOfRange)
{
  for (const int region : { -2, 2 })
  {
    shape::PiecewiseCharges charges = Nested(0.1, 0.0);
    charges.Regions(3) = region;
    std::string message;
    try
    {
      shape::PiecewiseHarmonicMap{ charges };
    }
    catch (const shape::InvalidInput& error)
    {
      message = error.what();
    }
    EXPECT_NE(message.find("bounds region " + std::to_string(region) + ","), std::string::npos)
      << message;
  }
}

TEST(PiecewiseHarmonicMap, RefusesWhatIsIncomplete)
{
  shape::PiecewiseCharges charges = Nested(0.1, 0.0);
  charges.Regions(3) = 2;
  EXPECT_REFUSED(shape::PiecewiseHarmonicMap{ charges }, "bounds region 2");
  charges = Nested(0.1, 0.0);
  charges.Regions.setZero();
  EXPECT_REFUSED(
    shape::PiecewiseHarmonicMap{ charges }, "no triangle of the map's surface bounds region 1");
  charges = Nested(0.1, 0.0);
  charges.Skins = Eigen::VectorXd::Constant(1, 0.1);
  EXPECT_REFUSED(shape::PiecewiseHarmonicMap{ charges }, "skins");
  charges = Nested(0.1, 0.0);
  shape::Mesh crossing = charges.Surface;
  crossing.Points.bottomRows(642).array() += 1.5;
  charges.Surface = crossing;
  EXPECT_REFUSED(shape::PiecewiseHarmonicMap{ charges }, "the surface of the Map");
}
