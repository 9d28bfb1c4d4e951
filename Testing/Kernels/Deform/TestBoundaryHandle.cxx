#include "Base/Errors.h"
#include "Deform/BoundaryHandle.h"
#include "Deform/HandleFrames.h"
#include "Support/DeformShapes.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace
{

using shapetest::Moved;
using shapetest::SomeRotation;

/// A closed curve in space.
Eigen::MatrixXd Wave(int samples)
{
  Eigen::MatrixXd positions(samples, 3);
  for (int i = 0; i < samples; ++i)
  {
    const double t = 2.0 * M_PI * i / samples;
    positions.row(i) << std::cos(t), 1.5 * std::sin(t), 0.3 * std::sin(2.0 * t);
  }
  return positions;
}

Eigen::MatrixXd RadialNormals(const Eigen::MatrixXd& positions)
{
  return positions.rowwise() + Eigen::RowVector3d(0, 0, 2.0);
}

double FarthestFrom(const shape::HandlePose& pose, const Eigen::Matrix3d& turn)
{
  double farthest = 0.0;
  for (const Eigen::Matrix3d& rotation : pose.Rotations)
  {
    farthest = std::max(farthest, (rotation - turn).norm());
  }
  return farthest;
}

/// Curves, closed and open, a planar one, a branching one, a surface, points; with no normals.
std::vector<shape::BoundaryHandle> ManyHandles()
{
  std::vector<shape::BoundaryHandle> handles = { shape::BuildCurveHandle(Wave(40), true),
    shape::BuildCurveHandle(Wave(40).topRows(11), false),
    shapetest::LoopOf(shapetest::FlatDisk(4)) };
  shape::BoundaryHandle branching = handles[1];
  branching.Positions.conservativeResize(13, 3);
  branching.Positions.bottomRows(2) << 0, 0, 1, 0, 0.5, 2;
  branching.Segments.conservativeResize(12, 2);
  branching.Segments.bottomRows(2) << 5, 11, 11, 12;
  handles.push_back(branching);
  const shape::Mesh cap = shapetest::Cap(5), flat = shapetest::FlatDisk(3);
  handles.push_back({ cap.Points, {}, cap.Triangles, {} });
  handles.push_back({ flat.Points, {}, flat.Triangles, {} });
  handles.push_back({ Wave(9), {}, {}, {} });
  return handles;
}

} // namespace

TEST(BoundaryHandle, TurnsWithARigidMotion)
{
  const Eigen::Matrix3d turn = SomeRotation();
  for (shape::BoundaryHandle handle : ManyHandles())
  {
    const Eigen::MatrixXd positions =
      Moved(handle.Positions, turn, 1.7, Eigen::RowVector3d(5, 6, 7));
    EXPECT_LT(FarthestFrom(shape::PoseHandle(handle, positions), turn), 1e-13);
    handle.Normals = RadialNormals(handle.Positions);
    const Eigen::MatrixXd normals = handle.Normals * turn.transpose();
    EXPECT_LT(FarthestFrom(shape::PoseHandle(handle, positions, normals), turn), 1e-13);
    EXPECT_EQ(FarthestFrom(shape::PoseHandle(handle, handle.Positions, handle.Normals),
                Eigen::Matrix3d::Identity()),
      0.0);
  }
}

TEST(BoundaryHandle, FramesTakeTangentsAndNormalsToTheNewOnes)
{
  shape::BoundaryHandle wave = shape::BuildCurveHandle(Wave(60), true, RadialNormals(Wave(60)));
  const Eigen::MatrixXd positions = shapetest::Bent(wave.Positions, 2.0);
  const Eigen::MatrixXd normals = RadialNormals(positions) * SomeRotation();
  const shape::HandlePose pose = shape::PoseHandle(wave, positions, normals);
  const Eigen::MatrixXd before = shape::ComputeHandleTangents(wave, wave.Positions);
  const Eigen::MatrixXd after = shape::ComputeHandleTangents(wave, positions);
  for (int i = 0; i < 60; ++i)
  {
    EXPECT_EQ(before.row(i), wave.Positions.row((i + 1) % 60) - wave.Positions.row((i + 59) % 60));
    const Eigen::Vector3d from = before.row(i).normalized().transpose();
    const Eigen::Vector3d to = after.row(i).normalized().transpose();
    EXPECT_LT((pose.Rotations[i] * from - to).norm(), 1e-13);
    // What is left of the normals beside the tangents.
    const Eigen::Vector3d n = wave.Normals.row(i).transpose(), m = normals.row(i).transpose();
    EXPECT_LT((pose.Rotations[i] * (n - n.dot(from) * from).normalized() -
                (m - m.dot(to) * to).normalized())
                .norm(),
      1e-13);
    EXPECT_NEAR(pose.Rotations[i].determinant(), 1.0, 1e-13);
  }
  // Without normals tangents are met, too.
  wave.Normals.resize(0, 0);
  const shape::HandlePose plain = shape::PoseHandle(wave, positions);
  for (int i = 0; i < 60; ++i)
  {
    EXPECT_LT((plain.Rotations[i] * before.row(i).normalized().transpose() -
                after.row(i).normalized().transpose())
                .norm(),
      1e-13);
  }
}

TEST(BoundaryHandle, DuplicatesAndFoldsHaveRotations)
{
  Eigen::MatrixXd positions = Wave(20);
  positions.row(7) = positions.row(6); // as polylines that repeat a point have it
  positions.row(15) = positions.row(13);
  const shape::BoundaryHandle handle = shape::BuildCurveHandle(positions, true);
  Eigen::MatrixXd to = positions;
  to.middleRows(1, 5).rowwise() = to.row(1); // collapsed at its target
  for (const Eigen::Matrix3d& rotation : shape::PoseHandle(handle, to).Rotations)
  {
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  }
}

TEST(BoundaryHandle, AnglesTurnAboutTangents)
{
  const shape::BoundaryHandle loop = shapetest::LoopOf(shapetest::FlatDisk(5));
  shape::HandlePose pose = shape::GetRestPose(loop);
  shape::RotateAboutTangents(
    loop, Eigen::VectorXd::Constant(loop.Positions.rows(), 0.5 * M_PI), pose);
  for (Eigen::Index i = 0; i < loop.Positions.rows(); ++i)
  {
    // Counter-clockwise: what pointed up points outwards... by the right-hand rule, inwards is up.
    const Eigen::Vector3d outwards = loop.Positions.row(i).normalized().transpose();
    EXPECT_LT((pose.Rotations[i] * Eigen::Vector3d::UnitZ() - outwards).norm(), 1e-12);
  }
}

TEST(BoundaryHandle, SetTurnsAreLinearInArcLength)
{
  Eigen::MatrixXd positions(6, 3);
  positions << 0, 0, 0, 1, 0, 0, 3, 0, 0, 3, 4, 0, 3, 5, 0, 3, 5, 2;
  const shape::BoundaryHandle open = shape::BuildCurveHandle(positions, false);
  shape::PrescribedRotations turns{ Eigen::MatrixXd::Zero(6, 3), Eigen::VectorXi::Zero(6) };
  turns.Turns(1, 2) = 0.3;
  turns.Turns(4, 2) = 0.3 + 7.0; // more than a whole turn
  turns.IsSet(1) = turns.IsSet(4) = 1;
  shape::HandlePose pose = shape::GetRestPose(open);
  shape::AddPrescribedRotations(open, turns, pose);
  const double angles[] = { 0.3, 0.3, 2.3, 6.3, 7.3, 7.3 }; // arc length from sample 1, and beyond
  for (int i = 0; i < 6; ++i)
  {
    const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(angles[i], Eigen::Vector3d::UnitZ()).toRotationMatrix();
    EXPECT_LT((pose.Rotations[i] - turn).norm(), 1e-12);
  }
  // One set sample of a closed curve turns all of it; none, none.
  const shape::BoundaryHandle closed = shape::BuildCurveHandle(Wave(30), true);
  shape::PrescribedRotations one{ Eigen::MatrixXd::Zero(30, 3), Eigen::VectorXi::Zero(30) };
  one.Turns.row(4) << 0.2, -0.4, 0.1;
  pose = shape::GetRestPose(closed);
  shape::AddPrescribedRotations(closed, one, pose);
  EXPECT_EQ(FarthestFrom(pose, Eigen::Matrix3d::Identity()), 0.0);
  one.IsSet(4) = 1;
  shape::AddPrescribedRotations(closed, one, pose);
  const Eigen::Vector3d turn(0.2, -0.4, 0.1);
  EXPECT_LT(
    FarthestFrom(pose, Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix()),
    1e-12);
}

TEST(BoundaryHandle, TheBiasFrameDrawsNormalsByItsWeight)
{
  const shape::Mesh cap = shapetest::Cap(8);
  const shape::BoundaryHandle loop = shapetest::LoopOf(cap);
  const Eigen::MatrixXd normals = shape::ComputeHandleNormals(loop, shape::BuildPointGraph(cap));
  const shape::HandlePose posed = shape::PoseHandle(
    loop, Moved(loop.Positions, SomeRotation(), 1.0, Eigen::RowVector3d(1, 2, 3)));
  const Eigen::Vector3d direction = Eigen::Vector3d(1, 1, 3).normalized();
  const auto anglesAt = [&](double weight)
  {
    shape::HandlePose pose = posed;
    shape::BiasFrames(loop, normals, { { 1, 1, 3 }, weight }, pose);
    Eigen::VectorXd angles(loop.Positions.rows());
    for (Eigen::Index i = 0; i < angles.size(); ++i)
    {
      const Eigen::Vector3d normal = pose.Rotations[i] * normals.row(i).transpose();
      angles(i) = std::atan2(normal.cross(direction).norm(), normal.dot(direction));
    }
    return angles;
  };
  const Eigen::VectorXd whole = anglesAt(0.0);
  EXPECT_GT(whole.minCoeff(), 0.01);
  for (const double weight : { 0.25, 0.5, 1.0 })
  {
    EXPECT_LT((anglesAt(weight) - (1.0 - weight) * whole).cwiseAbs().maxCoeff(), 1e-7);
  }
  // Opposite normals have a way, too.
  shape::HandlePose pose = shape::GetRestPose(loop);
  const Eigen::MatrixXd down = Eigen::RowVector3d(0, 0, -1).replicate(loop.Positions.rows(), 1);
  shape::BiasFrames(loop, down, { { 0, 0, 1 }, 1.0 }, pose);
  for (const Eigen::Matrix3d& rotation : pose.Rotations)
  {
    EXPECT_LT((rotation * Eigen::Vector3d(0, 0, -1) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  }
}

/// The angle between two rotations, in radians.
double AngleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
{
  const double sine = (a - b).norm() / std::sqrt(8.0);
  const double cosine = std::sqrt(std::max(1.0 + (a * b.transpose()).trace(), 0.0)) / 2.0;
  return 2.0 * std::atan2(sine, cosine);
}

TEST(BoundaryHandle, FramesApproachTheBiasFrameAlongGeodesics)
{
  // A wavy loop, bent and squeezed: all frames differ.
  const shape::BoundaryHandle loop = shape::BuildCurveHandle(Wave(24), true);
  Eigen::MatrixXd bent = Moved(loop.Positions, SomeRotation(), 1.0, Eigen::RowVector3d(1, 2, 3));
  bent.col(0) *= 0.6;
  bent.col(2).array() += 0.2 * bent.col(1).array().square();
  const shape::HandlePose posed = shape::PoseHandle(loop, bent);
  ASSERT_GT(FarthestFrom(posed, posed.Rotations[0]), 0.1);
  const Eigen::MatrixXd noNormals = Eigen::MatrixXd::Zero(24, 3);
  const Eigen::Matrix3d rest =
    Eigen::AngleAxisd(0.3, Eigen::Vector3d(0, 1, 1).normalized()).toRotationMatrix();
  const Eigen::Vector3d degrees(20.0, -35.0, 60.0);
  const Eigen::Matrix3d bias =
    Eigen::AngleAxisd(degrees.norm() * M_PI / 180.0, degrees.normalized()).toRotationMatrix() *
    rest;
  shape::PoseOptions options;
  options.BiasBy = shape::PoseOptions::BiasByType::Frame;
  options.BiasFrame = { 0.0, 0.0, 0.0 }; // without effect
  options.BiasRotation = { degrees.x(), degrees.y(), degrees.z() };
  for (const double weight : { 0.0, 0.1, 0.5, 0.75, 1.0 })
  {
    options.BiasWeight = weight;
    shape::HandlePose pose = posed;
    shape::BiasFrames(loop, noNormals, options, pose, rest);
    EXPECT_EQ(pose.Positions, bent);
    for (std::size_t i = 0; i < pose.Rotations.size(); ++i)
    {
      const Eigen::Matrix3d &before = posed.Rotations[i], &after = pose.Rotations[i];
      const double whole = AngleBetween(before, bias);
      EXPECT_GT(whole, 0.01);
      EXPECT_NEAR(AngleBetween(before, after), weight * whole, 1e-12);
      EXPECT_NEAR(AngleBetween(after, bias), (1.0 - weight) * whole, 1e-12);
      EXPECT_LT((after * after.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
      EXPECT_GT(after.determinant(), 0.0);
      if (weight == 0.0)
      {
        EXPECT_EQ(before, after);
      }
    }
  }
  options.BiasRotation[1] = std::numeric_limits<double>::quiet_NaN();
  shape::HandlePose pose = posed;
  EXPECT_REFUSED(shape::BiasFrames(loop, noNormals, options, pose), "BiasRotation");
}

TEST(BoundaryHandle, NamesWhatIsWrong)
{
  shape::BoundaryHandle handle = shape::BuildCurveHandle(Wave(8), true);
  Eigen::MatrixXd positions = Wave(8);
  EXPECT_REFUSED(shape::PoseHandle(handle, Wave(7)),
    "the handle has 8 points, but its target positions are 7 x 3");
  EXPECT_REFUSED(shape::PoseHandle(handle, positions, positions),
    "normals at its target, but not at its source");
  handle.Normals = positions;
  EXPECT_REFUSED(
    shape::PoseHandle(handle, positions), "normals at its source, but not at its target");
  positions(3, 2) = std::numeric_limits<double>::infinity();
  EXPECT_REFUSED(shape::PoseHandle(handle, positions, Wave(8)), "the handle's target positions");
  shape::HandlePose pose = shape::GetRestPose(handle);
  EXPECT_THROW(shape::AddPrescribedRotations(handle, { Wave(7), Eigen::VectorXi::Zero(7) }, pose),
    shape::InvalidInput);
  EXPECT_THROW(
    shape::BiasFrames(handle, positions, { { 0, 0, 1 }, 1.5 }, pose), shape::InvalidInput);
  EXPECT_THROW(
    shape::BiasFrames(handle, positions, { { 0, 0, 0 }, 0.5 }, pose), shape::InvalidInput);
}
