#include "Base/Errors.h"
#include "Deform/Deform.h"
#include "Support/DeformShapes.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace
{

using shapetest::Largest;

shape::DeformProblem SomeProblem()
{
  const shape::Mesh cap = shapetest::Cap(10);
  shape::DeformProblem problem{ { cap.Points, {}, cap.Triangles, {} }, shapetest::LoopOf(cap), {},
    {} };
  problem.Fields.Rigidity = Eigen::VectorXd::Ones(cap.Points.rows());
  return problem;
}

} // namespace

TEST(Deform, KeepsItsWeightsWhileOnlyTheTargetChanges)
{
  const shape::DeformProblem problem = SomeProblem();
  shape::Deformer deformer;
  for (const double radius : { 1.0, 1.5, 2.0 })
  {
    const shape::HandleTarget target{ shapetest::Bent(problem.Handle.Positions, radius), {}, {} };
    const Eigen::MatrixXd kept = deformer.Deform(problem, target).Points;
    EXPECT_EQ(deformer.HasPrepared(), radius == 1.0);
    EXPECT_EQ(kept, shape::Deformer().Deform(problem, target).Points);
    const Eigen::MatrixXd biased = deformer.Deform(problem, target, { { 1, 0, 0 }, 0.3 }).Points;
    EXPECT_FALSE(deformer.HasPrepared());
    EXPECT_GT(Largest(biased - kept), 0.01);
  }
}

TEST(Deform, PreparesAgainWhereAnythingElseChanges)
{
  using Problem = shape::DeformProblem;
  const std::function<void(Problem&)> changes[] = {
    [](Problem& one) { one.Shape.Points(0, 2) += 1e-9; },
    [](Problem& one) { std::swap(one.Shape.Triangles(0, 0), one.Shape.Triangles(0, 1)); },
    [](Problem& one) { one.Shape.Lines = Eigen::RowVector2i(0, 5); },
    [](Problem& one) { one.Shape.Tetrahedra = Eigen::RowVector4i(0, 1, 2, 3); },
    [](Problem& one) { one.Handle.Positions(3, 0) += 1e-9; },
    [](Problem& one) { one.Handle.Segments.conservativeResize(20, 2); },
    [](Problem& one) { one.Handle.Triangles = Eigen::RowVector3i(0, 1, 2); },
    [](Problem& one) { one.Fields.Rigidity(0) = 2.0; },
    [](Problem& one) { one.Fields.Scale = one.Fields.Rigidity; },
    [](Problem& one) { one.Fields.Segments = Eigen::VectorXi::Zero(one.Shape.Points.rows()); },
    [](Problem& one) { one.Options.Method = shape::DeformOptions::MethodType::BoundaryRelative; },
    [](Problem& one) { one.Options.Rigidity = 2.0; },
    [](Problem& one) { one.Options.RigidityBy = shape::DeformOptions::RigidityByType::Distance; },
    [](Problem& one) { one.Options.RigidityContrast = 2.0; },
    [](Problem& one) { one.Options.Scale = 2.0; },
    [](Problem& one) { one.Options.InnerScale = 2.0; },
    [](Problem& one) { one.Options.UpwindRadius = 3.0; },
    [](Problem& one) { one.Options.Distance = shape::FrontDistance::Geodesic; },
    [](Problem& one)
    { one.Options.Multiresolution = shape::DeformOptions::MultiresolutionType::On; },
    [](Problem& one) { one.Options.LaplacianSmoothing = true; },
  };
  const shape::DeformProblem before = SomeProblem();
  shape::Deformer deformer;
  for (const auto& change : changes)
  {
    deformer.Deform(before, { before.Handle.Positions, {}, {} });
    shape::DeformProblem after = before;
    change(after);
    const shape::HandleTarget target{ shapetest::Bent(after.Handle.Positions, 1.0), {}, {} };
    const Eigen::MatrixXd points = deformer.Deform(after, target).Points;
    EXPECT_TRUE(deformer.HasPrepared());
    EXPECT_EQ(points, shape::Deformer().Deform(after, target).Points);
  }
}

TEST(Deform, TheOrderOfPointsAndElementsDoesNotMatter)
{
  // A regular grid, where many edges are equally long, and a coarse base.
  const shape::Mesh square = shapetest::FlatSquare(50, 0.0);
  const auto n = static_cast<int>(square.Points.rows());
  shape::DeformProblem problem{ { square.Points, {}, square.Triangles, {} },
    shapetest::LoopOf(square), {}, {} };
  problem.Options.Multiresolution = shape::DeformOptions::MultiresolutionType::On;
  problem.Fields.Rigidity = Eigen::VectorXd::LinSpaced(n, 0.5, 2.0);
  const shape::HandleTarget target{ shapetest::Bent(problem.Handle.Positions, 1.0), {}, {} };
  const Eigen::MatrixXd before = shape::Deformer().Deform(problem, target).Points;
  std::vector<int> order(n), number(n);
  for (int i = 0; i < n; ++i)
  {
    order[i] = (i * 997 + 13) % n; // 2601 is no multiple of 997
    number[order[i]] = i;
  }
  problem.Shape.Points = Eigen::MatrixXd(square.Points(order, Eigen::all));
  problem.Fields.Rigidity = Eigen::VectorXd(problem.Fields.Rigidity(order));
  problem.Shape.Triangles =
    square.Triangles.colwise().reverse().unaryExpr([&](int point) { return number[point]; });
  const Eigen::MatrixXd after = shape::Deformer().Deform(problem, target).Points;
  EXPECT_LT(Largest(after - before(order, Eigen::all)), 1e-12);
  EXPECT_GT(Largest(before - square.Points), 0.2);
}

TEST(Deform, WhatFailsOrIsStoppedLeavesNothingWrong)
{
  const shape::DeformProblem problem = SomeProblem();
  const shape::HandleTarget target{ shapetest::Bent(problem.Handle.Positions, 1.0), {}, {} };
  const Eigen::MatrixXd points = shape::Deformer().Deform(problem, target).Points;
  shape::Deformer deformer;
  shape::DeformProblem wrong = problem;
  wrong.Options.Rigidity = -1.0;
  EXPECT_THROW(deformer.Deform(wrong, target), shape::InvalidInput);
  for (int last = 0; last < 8; ++last)
  {
    int calls = 0;
    EXPECT_THROW(
      deformer.Deform(problem, target, {}, shape::Progress([&](double) { return calls++ < last; })),
      shape::Aborted);
  }
  EXPECT_EQ(deformer.Deform(problem, target).Points, points);
  EXPECT_THROW(deformer.Deform(problem, { {}, {}, {} }), shape::InvalidInput);
  wrong = problem;
  wrong.Fields.Rigidity(17) = -1.0;
  wrong.Shape.Points(0, 2) +=
    0.1; // another shape, whose failure must not leave the first one's graph
  EXPECT_REFUSED(deformer.Deform(wrong, target), "at point 17");
  wrong.Fields.Rigidity(17) = 1.0;
  EXPECT_EQ(deformer.Deform(wrong, target).Points, shape::Deformer().Deform(wrong, target).Points);
  EXPECT_EQ(deformer.Deform(problem, target).Points, points);
}

TEST(Deform, WithTheWholeBiasEveryFrameIsTheBiasFrame)
{
  const shape::DeformProblem problem = SomeProblem();
  const Eigen::MatrixXd& rest = problem.Handle.Positions;
  const Eigen::Matrix3d tilt =
    Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 0).normalized()).toRotationMatrix();
  const shape::HandleTarget target{ rest * tilt.transpose(), {}, {} };
  shape::PoseOptions options;
  options.BiasBy = shape::PoseOptions::BiasByType::Frame;
  options.BiasWeight = 1.0;
  // The loop tilts, but the shape keeps its orientation: points move by means of the loop's ways.
  const shape::DeformedShape upright = shape::Deformer().Deform(problem, target, options);
  const Eigen::MatrixXd ways = target.Positions - rest;
  const Eigen::MatrixXd moved = upright.Points - problem.Shape.Points;
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_LT(moved.col(k).maxCoeff(), ways.col(k).maxCoeff() + 1e-12);
    EXPECT_GT(moved.col(k).minCoeff(), ways.col(k).minCoeff() - 1e-12);
  }
  options.BiasRotation = { 0.0, 0.0, 40.0 };
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(40.0 * M_PI / 180.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (const Eigen::Matrix3d& rotation :
    shape::Deformer().Deform(problem, target, options).Rotations)
  {
    EXPECT_LT((rotation - turn).norm(), 1e-12);
  }
}

TEST(Deform, SetTurnsAndTheBiasTurnFrames)
{
  const shape::DeformProblem problem = SomeProblem();
  const Eigen::Index samples = problem.Handle.Positions.rows();
  shape::HandleTarget target{ problem.Handle.Positions, {}, {} };
  target.Turns = { Eigen::MatrixXd::Zero(samples, 3), Eigen::VectorXi::Zero(samples) };
  target.Turns.Turns(0, 2) = 0.5;
  target.Turns.IsSet(0) = 1;
  shape::PoseOptions options;
  const Eigen::MatrixXd normals =
    shape::ComputeHandleNormals(problem.Handle, shape::BuildPointGraph(problem.Shape));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  for (const Eigen::Matrix3d& rotation :
    shape::PoseHandleAt(problem.Handle, target, options, normals).Rotations)
  {
    EXPECT_LT((rotation - turn).norm(), 1e-12);
  }
  options.BiasWeight = 1.0; // towards z, wherever the cap's normals point
  const shape::HandlePose pose = shape::PoseHandleAt(problem.Handle, target, options, normals);
  for (Eigen::Index i = 0; i < samples; ++i)
  {
    const Eigen::Vector3d normal = normals.row(i).transpose();
    EXPECT_LT((pose.Rotations[i] * normal.normalized() - Eigen::Vector3d::UnitZ()).norm(), 1e-7);
  }
}
