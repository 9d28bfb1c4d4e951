#include "Deform/Deform.h"
#include "Geometry/RotationVector.h"
#include "Support/DeformShapes.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{

using shapetest::Largest;
using shapetest::Moved;

const Eigen::Vector3d SomeTurn(0.4, -0.7, 0.2);
const Eigen::Vector3d SomeShift(2.0, -1.0, 0.5);

/// Both ends of a tube that narrows: the lower one is longer.
shape::Mesh Cone()
{
  shape::Mesh cone = shapetest::Tube(24, 20, 3.0);
  for (auto row : cone.Points.rowwise())
  {
    row.head<2>() *= 1.0 - 0.1 * row(2);
  }
  return cone;
}

shape::BoundaryHandle BothEnds(const shape::Mesh& tube)
{
  return shape::BuildLoopsHandle(tube.Points, shape::FindBoundaryLoops(tube).Loops);
}

shape::HandleTarget AtRest(const shape::BoundaryHandle& handle, const shape::HandleMotion& motion)
{
  return { handle.Positions, {}, {}, motion };
}

Eigen::MatrixXd Deform(const shape::Mesh& surface, const shape::BoundaryHandle& handle,
  const shape::HandleMotion& motion, double scale = 1.0)
{
  shape::DeformProblem problem{ { surface.Points, {}, surface.Triangles, {} }, handle, {}, {} };
  problem.Options.Scale = scale;
  return shape::Deformer().Deform(problem, AtRest(handle, motion)).Points;
}

/// The similarity about the centre of the handle that a motion of its only part is.
Eigen::MatrixXd Similar(const Eigen::MatrixXd& points, const Eigen::Vector3d& centre, double scale)
{
  const Eigen::RowVector3d shift =
    (centre + SomeShift - scale * shape::ToRotation(SomeTurn) * centre).transpose();
  return Moved(points, shape::ToRotation(SomeTurn), scale, shift);
}

/// A closed wave around the unit circle, beginning at sample `start`.
Eigen::MatrixXd WaveFrom(int start, int count)
{
  Eigen::MatrixXd positions(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * M_PI * ((i + start) % count) / count;
    positions.row(i) << std::cos(angle), std::sin(angle) + 0.2 * std::cos(2.0 * angle),
      0.3 * std::sin(3.0 * angle);
  }
  return positions;
}

shape::HandlePose PoseWithFrames(
  const shape::BoundaryHandle& handle, const std::vector<shape::FrameRotation>& frames)
{
  return shape::PoseHandleAt(
    handle, AtRest(handle, { {}, frames }), {}, Eigen::MatrixXd::Zero(handle.Positions.rows(), 3));
}

} // namespace

TEST(HandleMotion, PartsAreNumberedByTheirLengths)
{
  const shape::Mesh cone = Cone();
  const shape::BoundaryHandle handle = BothEnds(cone);
  const shape::HandleParts parts = shape::FindHandleParts(handle);
  ASSERT_EQ(parts.Count, 2);
  for (Eigen::Index i = 0; i < handle.Positions.rows(); ++i)
  {
    EXPECT_EQ(parts.PartOf[i], handle.Positions(i, 2) > 1.5 ? 1 : 0);
  }
  EXPECT_LT(
    (shape::ComputePartCentre(handle, parts, 1, handle.Positions) - Eigen::Vector3d(0.0, 0.0, 3.0))
      .norm(),
    1e-12);
  // A triangle, a short line, and two loose points.
  shape::BoundaryHandle mixed;
  mixed.Positions.resize(7, 3);
  mixed.Positions << 9, 9, 9, 0, 0, 0, 1, 0, 0, 5, 5, 5, 0, 1, 0, 5, 5, 5.1, -9, -9, -9;
  mixed.Segments = Eigen::RowVector2i(3, 5);
  mixed.Triangles = Eigen::RowVector3i(1, 2, 4);
  EXPECT_EQ(shape::FindHandleParts(mixed).PartOf, (std::vector<int>{ 2, 0, 0, 1, 0, 1, 2 }));
}

TEST(HandleMotion, TheCentreOfAPartDoesNotDependOnItsSampling)
{
  // A square, with many samples on one of its edges.
  Eigen::MatrixXd positions(8, 3);
  positions << 0, 0, 0, 0.1, 0, 0, 0.2, 0, 0, 0.3, 0, 0, 0.4, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  const shape::BoundaryHandle square = shape::BuildCurveHandle(positions, true);
  const Eigen::Vector3d centre =
    shape::ComputePartCentre(square, shape::FindHandleParts(square), 0, positions);
  EXPECT_LT((centre - Eigen::Vector3d(0.5, 0.5, 0.0)).norm(), 1e-14);
}

TEST(HandleMotion, NoMotionChangesNoBit)
{
  const shape::Mesh cone = Cone();
  const shape::BoundaryHandle handle = BothEnds(cone);
  const Eigen::MatrixXd still = Deform(cone, handle, {});
  EXPECT_EQ(still, cone.Points);
  EXPECT_EQ(still, Deform(cone, handle, { { {}, { 1 } }, { {} } }));
}

TEST(HandleMotion, AMotionOfTheWholeHandleIsThatOfTheShape)
{
  const shape::Mesh cap = shapetest::Cap(10);
  const shape::BoundaryHandle loop = shapetest::LoopOf(cap);
  const Eigen::Vector3d centre =
    shape::ComputePartCentre(loop, shape::FindHandleParts(loop), 0, loop.Positions);
  const double size = (cap.Points.colwise().maxCoeff() - cap.Points.colwise().minCoeff()).norm();
  EXPECT_LT(Largest(Deform(cap, loop, { { { 0, SomeShift, SomeTurn, 1.0 } }, {} }) -
              Similar(cap.Points, centre, 1.0)),
    1e-12 * size);
  // If the shape is scaled like its handle, that is a similarity.
  EXPECT_LT(Largest(Deform(cap, loop, { { { 0, SomeShift, SomeTurn, 1.7 } }, {} }, 1.7) -
              Similar(cap.Points, centre, 1.7)),
    1e-12 * size);
  // Frames move with their part.
  const std::vector<shape::FrameRotation> frames = { { loop.Positions.row(0).transpose(),
                                                       { 0.5, 0.0, 0.3 } },
    { loop.Positions.row(20).transpose(), Eigen::Vector3d::Zero() } };
  const Eigen::MatrixXd peeled = Deform(cap, loop, { {}, frames });
  EXPECT_GT(Largest(peeled - cap.Points), 0.05);
  EXPECT_LT(Largest(Deform(cap, loop, { { { 0, SomeShift, SomeTurn, 1.0 } }, frames }) -
              Similar(peeled, centre, 1.0)),
    1e-12 * size);
}

TEST(HandleMotion, OnePartMovesAndTheOthersStay)
{
  const shape::Mesh cone = Cone();
  const shape::BoundaryHandle handle = BothEnds(cone);
  const shape::HandleMotion motion{ { { 1, SomeShift, SomeTurn, 0.5 } }, {} };
  const shape::HandlePose pose = shape::PoseHandleAt(
    handle, AtRest(handle, motion), {}, Eigen::MatrixXd::Zero(handle.Positions.rows(), 3));
  const Eigen::Vector3d centre(0.0, 0.0, 3.0);
  for (Eigen::Index i = 0; i < handle.Positions.rows(); ++i)
  {
    const Eigen::RowVector3d rest = handle.Positions.row(i);
    const bool isMoved = rest(2) > 1.5;
    EXPECT_LT(Largest(pose.Positions.row(i) -
                (isMoved ? Similar(rest, centre, 0.5) : Eigen::MatrixXd(rest))),
      1e-14);
    const Eigen::Matrix3d turn =
      isMoved ? shape::ToRotation(SomeTurn) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    EXPECT_LT((pose.Rotations[i] - turn).norm(), 1e-14);
  }
  // The points of the shape that lie on the handle follow it, and the others lie between.
  const Eigen::MatrixXd bent = Deform(cone, handle, motion);
  EXPECT_LT(Largest(bent.topRows(24) - cone.Points.topRows(24)), 1e-12);
  EXPECT_LT(Largest(bent.bottomRows(24) - Similar(cone.Points.bottomRows(24), centre, 0.5)), 1e-12);
  EXPECT_GT(Largest(bent.middleRows(240, 24) - cone.Points.middleRows(240, 24)), 0.3);
}

TEST(HandleMotion, FramesThatAreAlikeRotateUniformly)
{
  const Eigen::MatrixXd wave = WaveFrom(0, 60);
  const shape::BoundaryHandle curve = shape::BuildCurveHandle(wave, true);
  std::vector<shape::FrameRotation> frames;
  for (const int sample : { 3, 17, 40 })
  {
    frames.push_back({ wave.row(sample).transpose(), SomeTurn });
    for (const Eigen::Matrix3d& rotation : PoseWithFrames(curve, frames).Rotations)
    {
      EXPECT_LT((rotation - shape::ToRotation(SomeTurn)).norm(), 1e-12);
    }
  }
}

TEST(HandleMotion, FramesDoNotDependOnWhereTheCurveBegins)
{
  const Eigen::MatrixXd wave = WaveFrom(0, 60);
  const std::vector<shape::FrameRotation> frames = { { wave.row(55).transpose(), SomeTurn },
    { wave.row(8).transpose(), { 0.0, 0.0, 2.0 } } };
  const shape::HandlePose pose = PoseWithFrames(shape::BuildCurveHandle(wave, true), frames);
  for (const int start : { 1, 5, 30, 57 })
  {
    const shape::HandlePose other =
      PoseWithFrames(shape::BuildCurveHandle(WaveFrom(start, 60), true), frames);
    for (int i = 0; i < 60; ++i)
    {
      EXPECT_LT((other.Rotations[i] - pose.Rotations[(i + start) % 60]).norm(), 1e-12);
    }
  }
}

TEST(HandleMotion, BetweenFramesRotationsAreMonotoneAndLinearInLength)
{
  // Two frames of a closed curve: both ways from one to the other, across the begin of the curve.
  const Eigen::MatrixXd wave = WaveFrom(0, 60);
  const shape::BoundaryHandle curve = shape::BuildCurveHandle(wave, true);
  const Eigen::Vector3d axis = SomeTurn.normalized();
  const std::vector<shape::FrameRotation> frames = { { wave.row(10).transpose(), 0.2 * axis },
    { wave.row(45).transpose(), 3.0 * axis } };
  const shape::HandlePose pose = PoseWithFrames(curve, frames);
  for (const int step : { 1, -1 })
  {
    std::vector<double> lengths{ 0.0 }, angles;
    for (int i = 10;; i = (i + step + 60) % 60)
    {
      const Eigen::AngleAxisd turn(pose.Rotations[i]);
      EXPECT_LT((turn.axis() - axis).norm(), 1e-9);
      angles.push_back(turn.angle());
      if (i == 45)
      {
        break;
      }
      lengths.push_back(lengths.back() + (wave.row((i + step + 60) % 60) - wave.row(i)).norm());
    }
    for (std::size_t k = 0; k < angles.size(); ++k)
    {
      EXPECT_NEAR(angles[k], 0.2 + 2.8 * lengths[k] / lengths.back(), 1e-12);
      EXPECT_TRUE(k == 0 || angles[k] > angles[k - 1]);
    }
  }
}

TEST(HandleMotion, AFrameAtTheInterpolatedRotationChangesNothing)
{
  const Eigen::MatrixXd wave = WaveFrom(0, 60);
  const shape::BoundaryHandle curve = shape::BuildCurveHandle(wave, true);
  std::vector<shape::FrameRotation> frames = { { wave.row(10).transpose(), SomeTurn },
    { wave.row(45).transpose(), { 0.0, 7.0, 1.0 } } };
  const Eigen::MatrixXd turns =
    shape::InterpolateRotations(curve, shape::PrescribeRotations(curve, frames));
  const shape::HandlePose pose = PoseWithFrames(curve, frames);
  frames.push_back({ wave.row(30).transpose(), turns.row(30).transpose() });
  const shape::HandlePose same = PoseWithFrames(curve, frames);
  for (int i = 0; i < 60; ++i)
  {
    EXPECT_LT((same.Rotations[i] - pose.Rotations[i]).norm(), 1e-12);
  }
}

TEST(HandleMotion, KeepsTheWeightsWhileOnlyTheMotionChanges)
{
  const shape::Mesh cone = Cone();
  const shape::DeformProblem problem{ { cone.Points, {}, cone.Triangles, {} }, BothEnds(cone), {},
    {} };
  shape::Deformer deformer;
  for (const double angle : { 0.0, 0.3, 0.6 })
  {
    const shape::HandleMotion motion{ { { 1, SomeShift, angle * SomeTurn, 1.0 + angle } },
      { { problem.Handle.Positions.row(3).transpose(), angle * SomeTurn } } };
    const shape::HandleTarget target = AtRest(problem.Handle, motion);
    EXPECT_EQ(
      deformer.Deform(problem, target).Points, shape::Deformer().Deform(problem, target).Points);
    EXPECT_EQ(deformer.HasPrepared(), angle == 0.0);
  }
}

TEST(HandleMotion, BadNumbersAreRefused)
{
  const shape::Mesh cone = Cone();
  const shape::BoundaryHandle handle = BothEnds(cone);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto move = [&](const shape::PartMotion& motion)
  {
    shape::HandlePose pose = shape::GetRestPose(handle);
    shape::MoveParts(handle, { motion }, pose);
  };
  EXPECT_REFUSED(move({ 2 }), "part 2", "2 parts", "from 0 to 1");
  EXPECT_REFUSED(move({ -1 }), "part -1", "from 0 to 1");
  EXPECT_REFUSED(move({ 0, SomeShift, SomeTurn, 0.0 }), "scale", "part 0", "positive");
  EXPECT_REFUSED(move({ 0, { nan, 0, 0 }, SomeTurn, 1.0 }), "not finite", "part 0");
  EXPECT_REFUSED(move({ 0, SomeShift, { 0, nan, 0 }, 1.0 }), "not finite", "part 0");
  EXPECT_REFUSED(
    shape::PrescribeRotations(handle, { {}, { { nan, 0, 0 }, SomeTurn } }), "row 1", "finite");
  const shape::ShapeElements shape{ cone.Points, {}, cone.Triangles, {} };
  EXPECT_NO_THROW(shape::RequireOnShape(handle, shape));
  shape::BoundaryHandle off = handle;
  off.Positions(30, 2) += 1.0;
  EXPECT_REFUSED(shape::RequireOnShape(off, shape), "point 30", "off the shape");
}
