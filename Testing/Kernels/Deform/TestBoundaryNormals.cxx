// Facts checked: frames that alone decide the normals turn by just the angles that are missing, all
// by one or each by its own; a real rim comes near to normals that it can have, turns with the
// space, and is never farther from any normals than it was; samples that want none do not count;
// angles between normals are right where they are tiny; what does not fit together is refused.

#include "Deform/BoundaryNormals.h"

#include "Base/Errors.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace
{

using Eigen::MatrixXd;
using Eigen::RowVector3d;

constexpr int Around = 32;
constexpr double Degree = M_PI / 180.0;

/// A tube, moved as the space is, and its lower rim as the handle.
struct Loop
{
  explicit Loop(const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity(),
    const RowVector3d& shift = RowVector3d::Zero())
    : Surface(shapetest::Tube(Around, 8, 1.6))
  {
    this->Surface.Points = shapetest::Moved(this->Surface.Points, turn, 1.0, shift);
    this->Handle = shape::BuildCurveHandle(this->Surface.Points.topRows(Around), true);
    this->Deformation =
      shape::PrepareDeformation(shape::BuildPointGraph(this->Surface), this->Handle);
    this->Options.Enough = 0.0;
    this->Options.Reach = 0.3; // the first ring, which is 0.2 away
  }

  shape::BoundaryNormalsResult Optimize(
    const MatrixXd& wanted, const shape::NormalsOfShape& normals) const
  {
    return shape::OptimizeBoundaryNormals(*this->Deformation, this->Handle,
      shape::GetRestPose(this->Handle), wanted, normals, this->Options);
  }

  shape::Mesh Surface;
  shape::BoundaryHandle Handle;
  std::unique_ptr<shape::ShapeDeformation> Deformation;
  shape::BoundaryNormalsOptions Options;
};

/// The normals of the tube's rim, each turned by an angle about the tangent.
MatrixXd Tilted(const Eigen::VectorXd& angles)
{
  MatrixXd normals(Around, 3);
  for (int i = 0; i < Around; ++i)
  {
    const double at = 2.0 * M_PI * i / Around, tilt = angles(i);
    normals.row(i) << std::cos(tilt) * std::cos(at), std::cos(tilt) * std::sin(at), -std::sin(tilt);
  }
  return normals;
}

/// Normals that turn with the frames, and by nothing else.
MatrixXd NormalsOfFrames(const shape::DeformedShape& deformed)
{
  MatrixXd normals = Tilted(Eigen::VectorXd::Zero(Around));
  for (int i = 0; i < Around; ++i)
  {
    normals.row(i) = normals.row(i) * deformed.Rotations[i].transpose();
  }
  return normals;
}

/// Those of the tube's sides between the rim and the ring beside it.
MatrixXd NormalsOfSides(const shape::DeformedShape& deformed)
{
  MatrixXd normals(Around, 3);
  for (int i = 0; i < Around; ++i)
  {
    const RowVector3d along =
      deformed.Points.row((i + 1) % Around) - deformed.Points.row((i + Around - 1) % Around);
    const RowVector3d up = deformed.Points.row(i + Around) - deformed.Points.row(i);
    normals.row(i) = along.cross(up).normalized();
  }
  return normals;
}

/// 20 degrees, and 10 more and less all around.
Eigen::VectorXd UnevenAngles()
{
  Eigen::VectorXd angles(Around);
  for (int i = 0; i < Around; ++i)
  {
    angles(i) = (20.0 + 10.0 * std::cos(2.0 * M_PI * i / Around)) * Degree;
  }
  return angles;
}

TEST(BoundaryNormals, FramesTurnByTheMissingAngles)
{
  Loop loop;
  const Eigen::VectorXd uneven = UnevenAngles(), even = Eigen::VectorXd::Constant(Around, -0.6);
  const shape::BoundaryNormalsResult each = loop.Optimize(Tilted(uneven), NormalsOfFrames);
  EXPECT_NEAR(each.Before, 20.0, 1e-9);
  EXPECT_LT(each.After, 0.05);
  EXPECT_LT((each.Angles - uneven).cwiseAbs().maxCoeff(), 0.1 * Degree);
  EXPECT_LE(each.LineSearches, 10);
  shape::HandlePose turned = shape::GetRestPose(loop.Handle);
  shape::RotateAboutTangents(loop.Handle, each.Angles, turned);
  EXPECT_EQ(each.Pose.Positions, loop.Handle.Positions);
  EXPECT_EQ(each.Pose.Rotations, turned.Rotations);

  loop.Options.SingleAngle = true;
  const shape::BoundaryNormalsResult one = loop.Optimize(Tilted(uneven), NormalsOfFrames);
  EXPECT_EQ(one.Angles.minCoeff(), one.Angles.maxCoeff());
  EXPECT_NEAR(one.Angles(0), 20.0 * Degree, 0.1 * Degree);
  EXPECT_NEAR(one.After, 10.0 * 2.0 / M_PI, 0.1); // the mean of a cosine's size
  const shape::BoundaryNormalsResult all = loop.Optimize(Tilted(even), NormalsOfFrames);
  EXPECT_LT((all.Angles - even).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(all.After, 1e-9);
  loop.Options.LineSearches = 0;
  const shape::BoundaryNormalsResult none = loop.Optimize(Tilted(even), NormalsOfFrames);
  EXPECT_EQ(none.Angles, Eigen::VectorXd(Eigen::VectorXd::Zero(Around)));
  EXPECT_EQ(none.After, none.Before);
}

TEST(BoundaryNormals, ARimComesNearToNormalsThatItCanHaveWhereverItIs)
{
  const MatrixXd wanted = Tilted(UnevenAngles());
  const Eigen::Matrix3d turn = shapetest::SomeRotation();
  Loop loop, moved(turn, { 3, -7, 2 });
  loop.Options.Enough = moved.Options.Enough = 2.0; // before rounding decides what is better
  const shape::BoundaryNormalsResult here = loop.Optimize(wanted, NormalsOfSides);
  EXPECT_LT(here.After, 0.05 * here.Before);
  const shape::BoundaryNormalsResult there =
    moved.Optimize(wanted * turn.transpose(), NormalsOfSides);
  EXPECT_LT((there.Angles - here.Angles).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(there.After, here.After, 1e-7);
}

/// Normals that turn six times as far as the frames, so that every step goes too far.
MatrixXd HastyNormals(const shape::DeformedShape& deformed)
{
  shape::DeformedShape hasty = deformed;
  for (Eigen::Matrix3d& rotation : hasty.Rotations)
  {
    Eigen::AngleAxisd turn(rotation);
    turn.angle() *= 6.0;
    rotation = turn.toRotationMatrix();
  }
  return NormalsOfFrames(hasty);
}

TEST(BoundaryNormals, NothingBecomesWorse)
{
  const Loop loop;
  for (const shape::NormalsOfShape& normals :
    { shape::NormalsOfShape(NormalsOfSides), shape::NormalsOfShape(HastyNormals) })
  {
    const auto energy = [&](const shape::HandlePose& pose, const MatrixXd& wanted)
    {
      const MatrixXd now = normals(loop.Deformation->Deform(pose, loop.Options.Reach));
      return (1.0 - now.cwiseProduct(wanted).rowwise().sum().array()).abs().sum();
    };
    for (int i = 0; i < 20; ++i)
    {
      const MatrixXd wanted = MatrixXd::Random(Around, 3).rowwise().normalized();
      const shape::BoundaryNormalsResult result = loop.Optimize(wanted, normals);
      EXPECT_LE(
        energy(result.Pose, wanted), energy(shape::GetRestPose(loop.Handle), wanted) + 1e-12);
    }
  }
}

TEST(BoundaryNormals, SamplesThatWantNoneDoNotCount)
{
  const Loop loop;
  const shape::BoundaryNormalsResult any =
    loop.Optimize(MatrixXd::Zero(Around, 3), NormalsOfFrames);
  EXPECT_EQ(any.Angles, Eigen::VectorXd(Eigen::VectorXd::Zero(Around)));
  EXPECT_EQ(any.Before, 0.0);
  EXPECT_EQ(any.After, 0.0);
  MatrixXd some = Tilted(Eigen::VectorXd::Constant(Around, 0.3));
  some.topRows(5).setZero();
  const shape::BoundaryNormalsResult rest = loop.Optimize(some, NormalsOfFrames);
  EXPECT_NEAR(rest.Before, 0.3 / Degree, 1e-9);
  EXPECT_LT(rest.After, 0.1);

  MatrixXd a(5, 3), b(5, 3);
  a << 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 1;
  b << 0, 1, 0, -1, 0, 0, 1, 1e-9, 0, 0, 0, 1, 0, 0, 0;
  EXPECT_NEAR(shape::ComputeMeanAngle(a.topRows(2), b.topRows(2)), 135.0, 1e-12);
  EXPECT_NEAR(shape::ComputeMeanAngle(a.row(2), b.row(2)) * Degree, 1e-9, 1e-18);
  EXPECT_NEAR(shape::ComputeMeanAngle(a, b), 90.0, 1e-7);
  EXPECT_EQ(shape::ComputeMeanAngle(a.bottomRows(2), b.bottomRows(2)), 0.0);
}

TEST(BoundaryNormals, RefusesWhatDoesNotFitTogether)
{
  const Loop loop;
  const MatrixXd wanted = Tilted(UnevenAngles());
  EXPECT_THROW(loop.Optimize(wanted.topRows(5), NormalsOfFrames), shape::InvalidInput);
  shape::HandlePose pose = shape::GetRestPose(loop.Handle);
  pose.Positions.conservativeResize(Around - 1, 3);
  EXPECT_THROW(
    shape::OptimizeBoundaryNormals(*loop.Deformation, loop.Handle, pose, wanted, NormalsOfFrames),
    shape::InvalidInput);
  EXPECT_THROW(
    shape::OptimizeBoundaryNormals(*loop.Deformation, loop.Handle, shape::GetRestPose(loop.Handle),
      wanted, NormalsOfFrames, {}, shape::Progress([](double) { return false; })),
    shape::Aborted);
}

} // namespace
