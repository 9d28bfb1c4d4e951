#include "Base/Parallel.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/VolumeTransform.h"
#include "Support/TestShapes.h"

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using State = shape::InverseMap::State;

/// A ball whose surface is mapped to itself with dents and a twist.
const shape::PiecewiseCharges& Charges()
{
  static const shape::PiecewiseCharges charges = []
  {
    const shape::Mesh ball = shapetest::Icosphere(3);
    Eigen::MatrixXd targets = ball.Points;
    for (Eigen::Index i = 0; i < targets.rows(); ++i)
    {
      const Eigen::RowVector3d p = ball.Points.row(i);
      targets.row(i) *= 1.1 - 0.3 * std::exp(-6.0 * (1.0 - p(0))) + 0.1 * std::sin(3.0 * p(1));
    }
    const auto result = shape::ComputeHarmonicVolumeMap(ball, targets);
    return shape::PiecewiseCharges{ { result.Map }, ball, {}, result.OffsetDistance, {} };
  }();
  return charges;
}

/// Positions in the ball, and beyond.
Eigen::MatrixXd Positions(double radius)
{
  const Eigen::MatrixXd unit = shapetest::Icosphere(2).Points;
  Eigen::MatrixXd positions(3 * unit.rows(), 3);
  positions << radius * unit, 0.6 * radius * unit, 0.1 * radius * unit;
  return positions;
}

} // namespace

TEST(PointCharges, AgreeWithTheSumsOverManyPlaces)
{
  // In units far from 1, too: the approximate root starts from a float.
  for (const double unit : { 1.0, 1e-30, 1e25 })
  {
    shape::ChargeSet set = Charges().Maps[0];
    set.Points *= unit;
    set.Charges *= unit;
    set.Affine.leftCols<3>() /= unit;
    const shape::PointCharges charges(set);
    const Eigen::MatrixXd positions = unit * Positions(0.95);
    const Eigen::MatrixXd values = shape::Evaluate(set, positions);
    const Eigen::MatrixXd jacobians = shape::EvaluateJacobians(set, positions);
    for (Eigen::Index i = 0; i < positions.rows(); ++i)
    {
      Eigen::Matrix3d jacobian;
      const Eigen::Vector3d position = positions.row(i);
      const Eigen::Vector3d value = charges.Evaluate(position, jacobian);
      EXPECT_LT((value - charges.Evaluate(position)).norm(), 1e-13);
      ASSERT_LT((value.transpose() - values.row(i)).norm(), 1e-12);
      for (int r = 0; r < 3; ++r)
      {
        ASSERT_LT((jacobian.row(r) - jacobians.block<1, 3>(i, 3 * r)).norm() * unit, 1e-11);
      }
    }
  }
}

TEST(PointCharges, OfNoChargeAreTheAffinePart)
{
  shape::ChargeSet set;
  set.Affine << 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 13;
  Eigen::Matrix3d jacobian;
  const Eigen::Vector3d value =
    shape::PointCharges(set).Evaluate(Eigen::Vector3d(1, 1, 2), jacobian);
  EXPECT_EQ(value, Eigen::Vector3d(13, 33, 54));
  EXPECT_EQ(jacobian, (set.Affine.leftCols<3>()));
}

TEST(VolumeTransform, OnePlaceAtATimeIsWhatManyAre)
{
  const shape::VolumeTransform transform(Charges(), true);
  const Eigen::MatrixXd positions = Positions(1.05);
  const auto forward = transform.Forward(positions);
  const auto backward = transform.Backward(positions);
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    const Eigen::Vector3d position = positions.row(i);
    EXPECT_EQ(forward[i].Position, transform.Forward(position).Position);
    EXPECT_EQ(backward[i].Position, transform.Backward(position).Position);
    EXPECT_EQ(forward[i].Jacobian, transform.Forward(position).Jacobian);
  }
}

TEST(VolumeTransform, ForwardUndoesBackwardAndOutsideKeepsItsPlace)
{
  const shape::VolumeTransform transform(Charges(), true);
  const double goal = 1e-11 * shape::ComputeLongestBoxEdge(Charges().Surface.Points()) * 1.3;
  int found = 0;
  for (const Eigen::MatrixXd& positions : { Positions(0.75), Positions(2.0) })
  {
    for (Eigen::Index i = 0; i < positions.rows(); ++i)
    {
      const Eigen::Vector3d position = positions.row(i);
      const auto back = transform.Backward(position);
      ASSERT_NE(back.State, State::Missed);
      if (back.State == State::Outside)
      {
        EXPECT_EQ(back.Position, position);
        EXPECT_TRUE(back.Jacobian.isIdentity(0.0));
        continue;
      }
      ++found;
      const auto forth = transform.Forward(back.Position);
      EXPECT_LE((forth.Position - position).norm(), goal);
      EXPECT_EQ(forth.Jacobian, back.Jacobian);
    }
  }
  EXPECT_GT(found, 3 * 162) << "all that lie in the image";
  EXPECT_LT(found, 6 * 162);
  const Eigen::Vector3d none(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  EXPECT_EQ(transform.Forward(none).State, State::Outside);
  EXPECT_EQ(transform.Backward(none).State, State::Outside);
}

TEST(VolumeTransform, AgreesWithTheInverseOfManyPoints)
{
  const shape::VolumeTransform transform(Charges(), true);
  const auto map = std::make_shared<const shape::PiecewiseHarmonicMap>(Charges());
  const shape::PiecewiseInverseMap inverse(map);
  const Eigen::MatrixXd positions = Positions(0.8);
  const auto many = inverse.Find(positions);
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    const auto one = transform.Backward(Eigen::Vector3d(positions.row(i)));
    EXPECT_EQ(static_cast<int>(one.State), many.States(i));
    EXPECT_LT((one.Position.transpose() - many.Points.row(i)).norm(), 1e-9);
  }
}
