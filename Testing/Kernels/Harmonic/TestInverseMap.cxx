#include "Base/Errors.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/InverseMap.h"
#include "Support/HarmonicShapes.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace
{

using shapetest::DentedSphere;
using State = shape::InverseMap::State;

/// The dented ball onto the ball.
const shape::HarmonicVolumeMapResult& DentedToBall()
{
  static const auto result =
    shape::ComputeHarmonicVolumeMap(DentedSphere(3), shapetest::Icosphere(3).Points);
  return result;
}

double Farthest()
{
  return 0.5 * DentedToBall().OffsetDistance * shape::ComputeLongestBoxEdge(DentedSphere(3).Points);
}

/// Shrunken copies of a surface around the origin.
Eigen::MatrixXd Shells(const Eigen::MatrixXd& surface)
{
  Eigen::MatrixXd shells(4 * surface.rows() + 1, 3);
  shells << 0.97 * surface, 0.8 * surface, 0.5 * surface, 0.1 * surface, Eigen::RowVector3d::Zero();
  return shells;
}

int Count(const shape::InverseMap::Result& result, State state)
{
  return static_cast<int>((result.States.array() == static_cast<int>(state)).count());
}

/// x -> (x^2, y, z) but for a linear part, as far as an harmonic map can: x^2 - z^2.
shape::ChargeSet Folding()
{
  shape::ChargeSet set;
  // Charges far away on the axes make second derivatives of any traceless kind.
  const double far = 40.0;
  set.Points = Eigen::MatrixXd(4, 3);
  set.Points << far, 0, 0, -far, 0, 0, 0, 0, far, 0, 0, -far;
  set.Charges = Eigen::MatrixXd::Zero(4, 3);
  const double strength = 4.0 * M_PI * far * far * far / 3.0;
  set.Charges.col(0) << strength, strength, -strength, -strength;
  set.Affine.setZero();
  set.Affine(1, 1) = set.Affine(2, 2) = 1.0;
  return set;
}

} // namespace

TEST(InverseMap, TheDerivativeIsThatOfTheMap)
{
  const shape::ChargeSet& map = DentedToBall().Map;
  const Eigen::MatrixXd points = Shells(0.9 * DentedSphere(1).Points);
  const Eigen::MatrixXd jacobians = shape::EvaluateJacobians(map, points);
  const double h = 1e-5;
  for (int c = 0; c < 3; ++c)
  {
    const Eigen::RowVector3d step = h * Eigen::RowVector3d::Unit(c);
    const Eigen::MatrixXd difference = (shape::Evaluate(map, points.rowwise() + step) -
                                         shape::Evaluate(map, points.rowwise() - step)) /
      (2.0 * h);
    for (int r = 0; r < 3; ++r)
    {
      EXPECT_LT((jacobians.col(3 * r + c) - difference.col(r)).cwiseAbs().maxCoeff(), 1e-7);
    }
  }
  // One charge: the derivative of a potential is traceless where the strength turns with the axes.
  shape::ChargeSet one;
  one.Points = Eigen::RowVector3d(0.0, 0.0, 2.0);
  one.Charges = Eigen::RowVector3d(0.0, 0.0, 4.0 * M_PI);
  const Eigen::MatrixXd at = shape::EvaluateJacobians(one, Eigen::RowVector3d::Zero());
  EXPECT_LT(
    (at - (Eigen::RowVectorXd(9) << 1, 0, 0, 0, 1, 0, 0, 0, 1.25).finished()).norm(), 1e-15);
}

TEST(InverseMap, OfAnAffineMapIsExact)
{
  shape::ChargeSet map;
  map.Affine << 1.2, 0.3, 0.0, 3.0, -0.1, 0.9, 0.2, -2.0, 0.0, 0.4, -1.1, 1.0;
  const shape::Mesh domain = DentedSphere(3);
  const Eigen::MatrixXd positions = Shells(domain.Points);
  const shape::InverseMap inverse(map, domain, 0.1);
  EXPECT_FALSE(inverse.Folds()) << "it turns orientation, which is no fold";
  const auto found = inverse.Find(shape::Evaluate(map, positions));
  EXPECT_EQ(Count(found, State::Found), positions.rows());
  EXPECT_LT((found.Points - positions).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(InverseMap, FindsWhereAHarmonicMapTookThePointsFrom)
{
  const shape::ChargeSet& map = DentedToBall().Map;
  const Eigen::MatrixXd positions = Shells(DentedSphere(3).Points);
  const Eigen::MatrixXd images = shape::Evaluate(map, positions);
  const shape::InverseMap inverse(map, DentedSphere(3), Farthest());
  EXPECT_FALSE(inverse.Folds());
  const auto found = inverse.Find(images);
  ASSERT_EQ(Count(found, State::Found), positions.rows());
  EXPECT_LT((shape::Evaluate(map, found.Points) - images).rowwise().norm().maxCoeff(), 2e-10);
  EXPECT_LT((found.Points - positions).rowwise().norm().maxCoeff(), 1e-9);
}

TEST(InverseMap, EveryPointOfTheImageHasAPreimageAndNoneBeyond)
{
  const shape::ChargeSet& map = DentedToBall().Map;
  const shape::InverseMap inverse(map, DentedSphere(3), Farthest());
  const auto inside = inverse.Find(Shells(shapetest::Icosphere(4).Points));
  EXPECT_EQ(Count(inside, State::Found), inside.States.size());

  const Eigen::MatrixXd beyond = 1.2 * shapetest::Icosphere(2).Points;
  const auto outside = inverse.Find(beyond);
  EXPECT_EQ(Count(outside, State::Outside), beyond.rows());
  EXPECT_EQ(outside.Points, beyond) << "points without a preimage keep their place";
}

TEST(InverseMap, OneSeedIsEnoughWhereTheWayIsWalked)
{
  const shape::ChargeSet& map = DentedToBall().Map;
  shape::InverseMapOptions poor;
  poor.SeedsAcross = 1;
  poor.MaximumIterations = 4;
  const Eigen::MatrixXd images = Shells(shapetest::Icosphere(3).Points);
  const auto found = shape::InverseMap(map, DentedSphere(3), Farthest(), poor).Find(images);
  ASSERT_EQ(Count(found, State::Found), images.rows());
  EXPECT_LT((shape::Evaluate(map, found.Points) - images).rowwise().norm().maxCoeff(), 2e-10);
}

TEST(InverseMap, OneOfTheTwoPreimagesUnderAFold)
{
  const shape::ChargeSet map = Folding();
  shape::Mesh domain = shapetest::Icosphere(3);
  const shape::InverseMap inverse(map, domain, 0.1);
  EXPECT_TRUE(inverse.Folds());
  // x and its mirror image have the same image, but for the charges' higher moments, which are
  // even.
  const Eigen::MatrixXd positions = Shells(0.9 * shapetest::Icosphere(1).Points);
  const Eigen::MatrixXd images = shape::Evaluate(map, positions);
  const auto found = inverse.Find(images);
  const auto again = inverse.Find(images);
  EXPECT_EQ(found.Points, again.Points);
  int checked = 0;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    // Near the fold the derivative has no inverse.
    if (std::abs(positions(i, 0)) > 0.05)
    {
      ASSERT_EQ(found.States(i), static_cast<int>(State::Found)) << positions.row(i);
      EXPECT_NEAR(std::abs(found.Points(i, 0)), std::abs(positions(i, 0)), 1e-7);
      EXPECT_LT((found.Points.row(i) - positions.row(i)).tail<2>().norm(), 1e-7);
      ++checked;
    }
  }
  EXPECT_GT(checked, 100);
  EXPECT_TRUE(found.Points.allFinite());
}

TEST(InverseMap, OfAFlatImageLeavesPointsWhereTheyAre)
{
  shape::ChargeSet flat;
  flat.Affine.setZero();
  flat.Affine(0, 0) = flat.Affine(1, 1) = 1.0;
  const shape::InverseMap inverse(flat, shapetest::Icosphere(2), 0.1);
  EXPECT_TRUE(inverse.Folds());
  Eigen::MatrixXd points(2, 3);
  points << 0.1, 0.2, 0.5, 3.0, 0.0, 0.0;
  const auto found = inverse.Find(points);
  EXPECT_EQ(Count(found, State::Found), 0);
  EXPECT_EQ(found.Points, points);
}

TEST(InverseMap, AgreesBitForBitForAnyNumberOfThreads)
{
  const shape::ChargeSet& map = DentedToBall().Map;
  const Eigen::MatrixXd images = Shells(shapetest::Icosphere(3).Points);
  const shape::InverseMap inverse(map, DentedSphere(3), Farthest());
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const auto one = inverse.Find(images);
  setenv("VTK_SMP_MAX_THREADS", "2", 1);
  const auto two = inverse.Find(images);
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(one.Points, two.Points);
  // Nor does a point's preimage depend on which points stand beside it.
  EXPECT_EQ(inverse.Find(images.middleRows(100, 7)).Points, one.Points.middleRows(100, 7));
}

TEST(InverseMap, RefusesAndAborts)
{
  const shape::Mesh domain = shapetest::Icosphere(2);
  shape::InverseMapOptions wrong;
  wrong.Tolerance = 0.0;
  EXPECT_THROW(shape::InverseMap({}, domain, 0.1, wrong), shape::InvalidInput);
  wrong = {};
  wrong.SeedsAcross = 0;
  EXPECT_THROW(shape::InverseMap({}, domain, 0.1, wrong), shape::InvalidInput);
  shape::ChargeSet touching;
  touching.Points = domain.Points.row(3);
  touching.Charges = Eigen::RowVector3d::Ones();
  EXPECT_THROW(shape::InverseMap(touching, domain, 0.1), shape::InvalidInput);
  const shape::Progress stop([](double) { return false; });
  EXPECT_THROW(shape::InverseMap({}, domain, 0.1, {}, stop), shape::Aborted);
  EXPECT_THROW(shape::InverseMap({}, domain, 0.1).Find(domain.Points, stop), shape::Aborted);
}
