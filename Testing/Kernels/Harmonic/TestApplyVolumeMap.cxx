#include "Base/Errors.h"
#include "Harmonic/ApplyVolumeMap.h"
#include "Harmonic/InverseMap.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

namespace
{

shape::ChargeSet SomeCharges()
{
  shape::ChargeSet map;
  map.Points = 2.0 * shapetest::Icosphere(0).Points;
  map.Charges = shapetest::Icosphere(0).Points.rowwise().reverse();
  map.Affine << 1, 0.2, 0, 3, 0, 0.9, 0.1, -2, 0.3, 0, 1.1, 0.5;
  return map;
}

shape::PiecewiseHarmonicMap InSphere(const shape::ChargeSet& map)
{
  return shape::PiecewiseHarmonicMap({ { map }, shapetest::Icosphere(3), {}, 0.2, {} });
}

} // namespace

TEST(ApplyVolumeMap, MovesWhatIsInsideByTheFormulaAndNothingElse)
{
  const shape::ChargeSet map = SomeCharges();
  const Eigen::MatrixXd unit = shapetest::Icosphere(2).Points;
  Eigen::MatrixXd points(3 * unit.rows(), 3);
  points << 0.6 * unit, 1.001 * unit, 1.5 * unit; // inside, within the tolerance, outside
  const shape::MovedPoints moved = shape::ApplyVolumeMap(InSphere(map), points);
  const Eigen::Index inside = 2 * unit.rows();
  EXPECT_EQ(moved.OutsideDomain.head(inside).sum(), 0);
  EXPECT_EQ(moved.OutsideDomain.tail(unit.rows()).sum(), unit.rows());
  EXPECT_EQ(moved.Points.topRows(inside), shape::Evaluate(map, points.topRows(inside)));
  EXPECT_EQ(moved.Points.bottomRows(unit.rows()), points.bottomRows(unit.rows()));
}

TEST(ApplyVolumeMap, TheInverseTakesItBack)
{
  const shape::ChargeSet map = SomeCharges();
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::MatrixXd points = 0.8 * shapetest::Icosphere(2).Points;
  const shape::MovedPoints moved = shape::ApplyVolumeMap(InSphere(map), points);
  const auto back = shape::InverseMap(map, sphere, 0.2).Find(moved.Points);
  EXPECT_EQ(back.States.sum(), 0);
  EXPECT_LT((back.Points - points).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(ApplyVolumeMap, RefusesAMapThatIsNotFiniteInsideAndAborts)
{
  shape::ChargeSet map = SomeCharges();
  EXPECT_THROW(
    shape::ApplyVolumeMap(InSphere(map), map.Points, shape::Progress([](double) { return false; })),
    shape::Aborted);
  EXPECT_NO_THROW(shape::ApplyVolumeMap(InSphere(map), map.Points)) << "charges lie outside";
  map.Points *= 0.25;
  EXPECT_THROW(shape::ApplyVolumeMap(InSphere(map), map.Points), shape::SolveFailure);
}
