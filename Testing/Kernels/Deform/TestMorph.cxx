#include "Deform/Morph.h"
#include "Geometry/FitRotation.h"
#include "Support/DeformShapes.h"
#include "Support/ProgressChecks.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{

using shapetest::ElementsOf;
using shapetest::HasWords;
using shapetest::Largest;
using shapetest::Refusal;

/// A tube of radius 0.25 from x = 0 to 6.
shape::ShapeElements Arm()
{
  shape::Mesh tube = shapetest::Tube(12, 72, 24.0);
  Eigen::MatrixXd points(tube.Points.rows(), 3);
  points << tube.Points.col(2), tube.Points.col(0), tube.Points.col(1);
  tube.Points = 0.25 * points;
  return ElementsOf(tube);
}

/// A bar of tetrahedra along z, 2 wide and 16 long.
shape::ShapeElements Bar()
{
  return shapetest::Block(3, 24, 16.0);
}

/// Rotates what is beyond x = 3 about the z axis there. On a length of 1, the angle grows evenly.
Eigen::MatrixXd Hinged(Eigen::MatrixXd points, double angle)
{
  const double bend = 1.0, radius = bend / angle;
  for (auto row : points.rowwise())
  {
    const double s = row(0) - 2.5, turned = angle * std::clamp(s / bend, 0.0, 1.0);
    const double beyond = std::max(0.0, s - bend), y = row(1);
    if (s > 0.0)
    {
      row(0) = 2.5 + (radius - y) * std::sin(turned) + beyond * std::cos(angle);
      row(1) = radius - (radius - y) * std::cos(turned) + beyond * std::sin(angle);
    }
  }
  return points;
}

/// Twists a bar along z by an angle that grows evenly.
Eigen::MatrixXd Twisted(Eigen::MatrixXd points, double angle)
{
  const double length = points.col(2).maxCoeff();
  for (auto row : points.rowwise())
  {
    const Eigen::Rotation2Dd turn(angle * row(2) / length);
    row.head<2>() = (turn * Eigen::Vector2d(row(0), row(1))).transpose().eval();
  }
  return points;
}

double LengthOfForearm(const Eigen::MatrixXd& arm)
{
  // Rings 48 and 72, from x = 4 to 6.
  return (
    arm.middleRows(48 * 12, 12).colwise().mean() - arm.middleRows(72 * 12, 12).colwise().mean())
    .norm();
}

/// The largest distance after the best translation.
double DifferenceOf(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  const Eigen::MatrixXd difference = a - b;
  return Largest(difference.rowwise() - difference.colwise().mean());
}

} // namespace

TEST(Morph, WeightsOfZeroAndOneGiveTheShapeAndItsTargets)
{
  for (const shape::ShapeElements& shape : { Arm(), Bar() })
  {
    const std::vector<Eigen::MatrixXd> targets = { shapetest::Bent(shape.Points, 2.0),
      Twisted(3.0 * shape.Points, 2.0) };
    const shape::RigidMorph morph(shape, targets);
    EXPECT_LT(Largest(morph.At({ 0.0, 0.0 }) - shape.Points), 1e-11);
    EXPECT_LT(Largest(morph.At({ 1.0, 0.0 }) - targets[0]), 1e-11);
    EXPECT_LT(Largest(morph.At({ 0.0, 1.0 }) - targets[1]), 1e-11);
  }
}

TEST(Morph, RigidMotionIsARotationAtConstantSpeed)
{
  const shape::ShapeElements arm = Arm();
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -1).normalized();
  const Eigen::RowVector3d centre = arm.Points.colwise().mean(), shift(3, 1, 2);
  const auto moved = [&](double share)
  {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.5 * share, axis).toRotationMatrix();
    return Eigen::MatrixXd(
      ((arm.Points.rowwise() - centre) * turn.transpose()).rowwise() + (centre + share * shift));
  };
  const shape::RigidMorph morph(arm, { moved(1.0) });
  for (const double share : { 0.2, 0.5, 0.9, 1.3 })
  {
    EXPECT_LT(Largest(morph.At({ share }) - moved(share)), 1e-10) << share;
  }
}

TEST(Morph, LimbsThatRotateKeepTheirLengths)
{
  const shape::ShapeElements arm = Arm();
  for (const double angle : { 1.5, 2.6 })
  {
    const Eigen::MatrixXd target = Hinged(arm.Points, angle);
    const double length = LengthOfForearm(arm.Points);
    ASSERT_NEAR(LengthOfForearm(target), length, 1e-12);
    const shape::RigidMorph morph(arm, { target });
    for (const double share : { 0.25, 0.5, 0.75 })
    {
      EXPECT_NEAR(LengthOfForearm(morph.At({ share })), length, 0.005 * length) << share;
      // In a straight line, it is shorter: by 27 % and 73 % in the middle.
      const Eigen::MatrixXd straight = (1.0 - share) * arm.Points + share * target;
      EXPECT_LT(LengthOfForearm(straight), 0.85 * length);
      // The angle grows evenly.
      EXPECT_LT(DifferenceOf(morph.At({ share }), Hinged(arm.Points, share * angle)), 0.05);
    }
  }
}

TEST(Morph, TwistMayBeSeveralTurns)
{
  // On the way, each layer of points is rotated from the one below it by the share of the angle.
  const shape::ShapeElements bar = Bar();
  constexpr Eigen::Index layer = 16, layers = 25;
  const auto angleOf = [&](const Eigen::MatrixXd& points, Eigen::Index k)
  {
    const auto centred = [&](Eigen::Index number)
    {
      const Eigen::MatrixXd own = points.middleRows(layer * number, layer);
      return Eigen::MatrixXd(own.rowwise() - own.colwise().mean());
    };
    const Eigen::Matrix3d turn = shape::FitRotation(centred(k + 1).transpose() * centred(k));
    return Eigen::AngleAxisd(turn).angle();
  };
  for (const double angle : { 2.5, 6.5, 8.0 })
  {
    const shape::RigidMorph morph(bar, { Twisted(bar.Points, angle) });
    for (const double share : { 0.3, 0.6 })
    {
      const Eigen::MatrixXd moved = morph.At({ share });
      for (Eigen::Index k = 0; k + 1 < layers; ++k)
      {
        const double expected = share * angle / (layers - 1);
        EXPECT_NEAR(angleOf(moved, k), expected, 0.1 * expected) << angle << ", layer " << k;
      }
    }
  }
}

TEST(Morph, TargetsAddTheirMotions)
{
  // Both limbs of a bar bend, each in a target of its own.
  const shape::ShapeElements arm = Arm();
  const Eigen::RowVector3d mirror(-1, 1, 1), shift(6, 0, 0);
  const auto left = [&](const Eigen::MatrixXd& points, double angle)
  {
    Eigen::MatrixXd bent = points * mirror.asDiagonal();
    bent = Hinged(bent.rowwise() + shift, angle);
    return Eigen::MatrixXd((bent.rowwise() - shift) * mirror.asDiagonal());
  };
  const shape::RigidMorph morph(arm, { Hinged(arm.Points, 1.0), left(arm.Points, 1.0) });
  const Eigen::MatrixXd both = morph.At({ 0.8, 0.6 });
  EXPECT_NEAR(LengthOfForearm(both), LengthOfForearm(arm.Points), 0.01);
  // Without the hinge, where they meet, the ends rotate by the sum of both angles.
  const auto direction = [](const Eigen::MatrixXd& points, int ring)
  {
    return Eigen::RowVector3d((points.middleRows(12 * (ring + 12), 12).colwise().mean() -
      points.middleRows(12 * ring, 12).colwise().mean())
                                .normalized());
  };
  const double angle = std::acos(direction(both, 2).dot(direction(both, 58)));
  EXPECT_NEAR(angle, 1.4, 0.02);
}

TEST(Morph, ComponentsAndLoosePointsMoveByThemselves)
{
  shape::ShapeElements arm = Arm();
  const Eigen::Index count = arm.Points.rows();
  shape::ShapeElements two;
  two.Points.resize(2 * count + 1, 3);
  two.Points << arm.Points, arm.Points.rowwise() + Eigen::RowVector3d(0, 5, 0), 7, 7, 7;
  two.Triangles.resize(2 * arm.Triangles.rows(), 3);
  two.Triangles << arm.Triangles, arm.Triangles.array() + static_cast<int>(count);
  two.Lines.resize(0, 2);
  two.Tetrahedra.resize(0, 4);
  Eigen::MatrixXd target = two.Points;
  target.topRows(count) = Hinged(arm.Points, 1.5);
  target.bottomRows(1) << 8, 7, 9;
  const Eigen::MatrixXd middle = shape::RigidMorph(two, { target }).At({ 0.5 });
  const Eigen::MatrixXd alone = shape::RigidMorph(arm, { Hinged(arm.Points, 1.5) }).At({ 0.5 });
  EXPECT_LT(Largest(middle.topRows(count) - alone), 1e-11);
  EXPECT_LT(Largest(middle.middleRows(count, count) - two.Points.middleRows(count, count)), 1e-11);
  EXPECT_LT((middle.row(2 * count) - Eigen::RowVector3d(7.5, 7, 8)).norm(), 1e-12);
}

TEST(Morph, PointsThatCoincideEverywhereMoveAsOne)
{
  // The same arm as a soup, whose triangles share no points.
  const shape::ShapeElements arm = Arm();
  const Eigen::MatrixXd target = Hinged(arm.Points, 2.0);
  shape::ShapeElements soup = arm;
  const Eigen::Index count = arm.Triangles.size();
  std::vector<int> copies;
  for (Eigen::Index i = 0; i < arm.Triangles.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      soup.Triangles(i, k) = static_cast<int>(copies.size());
      copies.push_back(arm.Triangles(i, k));
    }
  }
  ASSERT_EQ(static_cast<Eigen::Index>(copies.size()), count);
  soup.Points = arm.Points(copies, Eigen::all);
  const Eigen::MatrixXd moved = shape::RigidMorph(soup, { target(copies, Eigen::all) }).At({ 0.5 });
  const Eigen::MatrixXd expected = shape::RigidMorph(arm, { target }).At({ 0.5 });
  EXPECT_LT(Largest(moved - expected(copies, Eigen::all)), 1e-10);
}

TEST(Morph, CurvesAndTrianglesWithoutAreaAreReached)
{
  // A zigzag line that bends, and a triangle that collapses.
  shape::ShapeElements mixed;
  mixed.Points.resize(8, 3);
  mixed.Points << 0, 0, 0, 1, 0.2, 0, 2, 0, 0, 3, 0.2, 0, 4, 0, 0, 0, 2, 0, 1, 2, 0, 0, 3, 0;
  mixed.Lines.resize(4, 2);
  mixed.Lines << 0, 1, 1, 2, 2, 3, 3, 4;
  mixed.Triangles.resize(1, 3);
  mixed.Triangles << 5, 6, 7;
  mixed.Tetrahedra.resize(0, 4);
  Eigen::MatrixXd target = shapetest::Bent(mixed.Points, 2.0);
  target.row(7) = 0.5 * (target.row(5) + target.row(6));
  for (const bool reverse : { false, true })
  {
    shape::ShapeElements from = mixed;
    from.Points = reverse ? target : mixed.Points;
    const Eigen::MatrixXd& to = reverse ? mixed.Points : target;
    const shape::RigidMorph morph(from, { to });
    EXPECT_LT(Largest(morph.At({ 1.0 }) - to), 1e-9);
    EXPECT_TRUE(morph.At({ 0.5 }).allFinite());
  }
  // On the way, the line keeps its length better than in straight lines.
  const auto length = [](const Eigen::MatrixXd& points)
  { return (points.topRows(4) - points.middleRows(1, 4)).rowwise().norm().sum(); };
  const double middle = length(shape::RigidMorph(mixed, { target }).At({ 0.5 }));
  EXPECT_NEAR(middle, 0.5 * (length(mixed.Points) + length(target)), 1e-3);
  EXPECT_LT(length(0.5 * (mixed.Points + target)), 0.97 * middle);
}

TEST(Morph, RefusesOtherPointsAndWeights)
{
  const shape::ShapeElements arm = Arm();
  Eigen::MatrixXd target = Hinged(arm.Points, 1.0);
  EXPECT_TRUE(HasWords(Refusal([&] { shape::RigidMorph(arm, {}); }), { "no target", "give" }));
  EXPECT_TRUE(HasWords(Refusal([&] { shape::RigidMorph(arm, { target.topRows(5) }); }),
    { "5 points", std::to_string(target.rows()), "give" }));
  const shape::RigidMorph morph(arm, { target });
  EXPECT_TRUE(HasWords(Refusal([&] { morph.At({ 0.5, 0.5 }); }), { "2 weights for 1 targets" }));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(HasWords(Refusal([&] { morph.At({ nan }); }), { "finite" }));
  target(3, 1) = nan;
  EXPECT_TRUE(HasWords(Refusal([&] { shape::RigidMorph(arm, { target }); }), { "finite" }));
}

TEST(Morph, ReportsProgressAndStops)
{
  const shape::ShapeElements arm = Arm();
  const Eigen::MatrixXd target = Hinged(arm.Points, 1.0);
  const auto run = [&](const shape::Progress& progress)
  { shape::RigidMorph(arm, { target }, progress).At({ 0.5 }); };
  EXPECT_GE(shapetest::ExpectProgressRises([&](const shape::Progress& progress)
              { shape::RigidMorph(arm, { target }, progress); }),
    3);
  shapetest::ExpectStopsAt(2, run);
}
