#include "Base/Errors.h"
#include "Deform/Private/FrontDeformation.h"
#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"
#include "Support/Deformations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

using Options = shape::DeformOptions;
using shapetest::Bent;
using shapetest::Largest;

Options InFull()
{
  Options options;
  options.Multiresolution = Options::MultiresolutionType::Off;
  return options;
}

/// The first `count` points, which are a ring, as a handle.
shape::BoundaryHandle FirstRing(const shape::Mesh& tube, int count)
{
  return shape::BuildCurveHandle(tube.Points.topRows(count), true);
}

shape::DeformedShape DeformedTo(const shape::Mesh& mesh, const shape::BoundaryHandle& handle,
  const Eigen::MatrixXd& target, const Options& options = InFull())
{
  return shape::ShapeDeformation(shape::BuildPointGraph(mesh), handle, options)
    .Deform(shape::PoseHandle(handle, target));
}

/// The points of each ring of a tube: their mean.
Eigen::MatrixXd Centres(const Eigen::MatrixXd& points, int around)
{
  Eigen::MatrixXd centres(points.rows() / around, 3);
  for (Eigen::Index i = 0; i < centres.rows(); ++i)
  {
    centres.row(i) = points.middleRows(around * i, around).colwise().mean();
  }
  return centres;
}

} // namespace

TEST(FrontDeformation, ALongTubeDoesNotDrift)
{
  // The rim keeps its shape; its frames are turned by noise. After 400 rings the tube is as long,
  // as straight and as round as before, and its frames are rotations.
  constexpr int around = 24, along = 400;
  const shape::Mesh tube = shapetest::Tube(around, along, 100.0);
  const shape::BoundaryHandle loop = FirstRing(tube, around);
  shape::HandlePose pose = shape::PoseHandle(
    loop, shapetest::Moved(loop.Positions, shapetest::SomeRotation(), 1.0, { 1, 2, 3 }));
  const shape::ShapeDeformation prepared(shape::BuildPointGraph(tube), loop, InFull());
  EXPECT_LT(Largest(prepared.Deform(pose).Points -
              shapetest::Moved(tube.Points, shapetest::SomeRotation(), 1.0, { 1, 2, 3 })),
    1e-12 * shape::ComputeBoxDiagonal(tube.Points));
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  constexpr double noise = 1e-3;
  for (Eigen::Matrix3d& rotation : pose.Rotations)
  {
    const Eigen::Vector3d axis(uniform(generator), uniform(generator), uniform(generator));
    rotation = Eigen::AngleAxisd(noise * uniform(generator), axis.normalized()) * rotation;
  }
  const shape::DeformedShape moved = prepared.Deform(pose);
  // A frame's noise tilts the whole by less than itself, once.
  const Eigen::MatrixXd centres = Centres(moved.Points, around);
  const Eigen::RowVector3d chord = centres.row(along) - centres.row(0);
  EXPECT_NEAR(chord.norm(), 100.0, 100.0 * noise);
  double bow = 0.0;
  for (int i = 0; i <= along; ++i)
  {
    const Eigen::RowVector3d way = centres.row(i) - centres.row(0);
    bow = std::max(bow, (way - way.dot(chord) / chord.squaredNorm() * chord).norm());
  }
  EXPECT_LT(bow, 100.0 * noise);
  for (const Eigen::Matrix3d& rotation : moved.Rotations)
  {
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-13);
  }
  double roundest = 0.0;
  for (int j = 0; j < around; ++j)
  {
    roundest = std::max(
      roundest, std::abs((moved.Points.row(around * along + j) - centres.row(along)).norm() - 1.0));
  }
  EXPECT_LT(roundest, 0.1);
}

TEST(FrontDeformation, ABentRimBecomesRoundAgainFarAway)
{
  constexpr int around = 48, along = 100;
  const shape::Mesh tube = shapetest::Tube(around, along, 10.0);
  const shape::BoundaryHandle loop = FirstRing(tube, around);
  const Eigen::MatrixXd target = Bent(loop.Positions, 1.3);
  const Eigen::MatrixXd moved = DeformedTo(tube, loop, target).Points;
  const Eigen::MatrixXd centres = Centres(moved, around);
  const auto unevenness = [&](int ring)
  {
    const Eigen::VectorXd radii =
      (moved.middleRows(around * ring, around).rowwise() - centres.row(ring)).rowwise().norm();
    return radii.maxCoeff() - radii.minCoeff();
  };
  EXPECT_GT(unevenness(0), 0.05);
  for (int ring = 10; ring <= along; ring += 10)
  {
    // As an elastic tube, it passes an oval on for some diameters before it is round.
    EXPECT_LT(unevenness(ring), ring < 30 ? unevenness(0) : 0.7 * unevenness(ring - 10));
    // Length is kept: no squashing.
    EXPECT_NEAR(centres(ring, 2) - centres(ring - 10, 2), 1.0, 0.02);
  }
  EXPECT_LT(unevenness(along), 1e-3);
}

TEST(FrontDeformation, JitterOfARegularGridDoesNotBias)
{
  constexpr int around = 48, along = 40;
  const shape::Mesh tube = shapetest::Tube(around, along, 4.0);
  const shape::BoundaryHandle loop = FirstRing(tube, around);
  const Eigen::MatrixXd target = Bent(loop.Positions, 1.3);
  const Eigen::MatrixXd before = DeformedTo(tube, loop, target).Points;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const double share : { 1e-9, 1e-6, 1e-3, 1e-2 })
  {
    shape::Mesh shaken = tube;
    for (Eigen::Index i = around; i < shaken.Points.rows(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        shaken.Points(i, c) += 0.1 * share * uniform(generator); // edges are 0.1
      }
    }
    // What arrives together in one and not in the other would change the result at once.
    EXPECT_LT(Largest(DeformedTo(shaken, loop, target).Points - before), 0.5 * share + 1e-12);
  }
}

TEST(FrontDeformation, ALocallyDensifiedMeshGivesTheOriginalsResult)
{
  const shape::Mesh cap = shapetest::Cap(16);
  const shape::BoundaryHandle loop = shapetest::LoopOf(cap);
  const Eigen::MatrixXd target = Bent(loop.Positions, 1.0);
  const Eigen::MatrixXd before = DeformedTo(cap, loop, target).Points;
  EXPECT_GT(Largest(before - cap.Points), 0.5);
  shape::Mesh dense = cap;
  for (int round = 0; round < 3; ++round)
  {
    // A point in the middle of each triangle on one side.
    for (Eigen::Index t = dense.Triangles.rows() - 1; t >= 0; --t)
    {
      const Eigen::RowVector3d centre = shape::GetCorners(dense, t).colwise().mean();
      if ((centre.head<2>() - Eigen::RowVector2d(0.5, 0.0)).norm() < 0.25)
      {
        const Eigen::RowVector3i corners = dense.Triangles.row(t);
        const auto n = static_cast<int>(dense.Points.rows());
        dense.Points.conservativeResize(n + 1, 3);
        dense.Points.row(n) = centre;
        const Eigen::Index m = dense.Triangles.rows();
        dense.Triangles.conservativeResize(m + 2, 3);
        dense.Triangles.row(t) << corners(0), corners(1), n;
        dense.Triangles.row(m) << corners(1), corners(2), n;
        dense.Triangles.row(m + 1) << corners(2), corners(0), n;
      }
    }
  }
  EXPECT_GT(dense.Points.rows(), 2 * cap.Points.rows());
  const Eigen::MatrixXd after = DeformedTo(dense, loop, target).Points;
  EXPECT_LT(Largest(after.topRows(cap.Points.rows()) - before), 0.02);
}

TEST(FrontDeformation, MoreSamplesOnTheSameLoopGiveTheSame)
{
  const shape::Mesh cap = shapetest::Cap(16);
  const shape::BoundaryHandle loop = shapetest::LoopOf(cap);
  const Eigen::MatrixXd target = Bent(loop.Positions, 1.0);
  const shape::HandlePose pose = shape::PoseHandle(loop, target);
  const shape::PointGraph graph = shape::BuildPointGraph(cap);
  // Half of the segments get nine samples more, their frames in between.
  shape::BoundaryHandle uneven;
  shape::HandlePose posed;
  const Eigen::Index n = loop.Positions.rows();
  std::vector<Eigen::RowVector3d> positions, targets;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const Eigen::Index next = (i + 1) % n;
    const int pieces = i < n / 2 ? 10 : 1;
    const Eigen::Quaterniond from(pose.Rotations[i]), to(pose.Rotations[next]);
    for (int k = 0; k < pieces; ++k)
    {
      const double t = static_cast<double>(k) / pieces;
      positions.emplace_back((1.0 - t) * loop.Positions.row(i) + t * loop.Positions.row(next));
      targets.emplace_back((1.0 - t) * target.row(i) + t * target.row(next));
      posed.Rotations.push_back(from.slerp(t, to).toRotationMatrix());
    }
  }
  Eigen::MatrixXd rows(positions.size(), 3);
  posed.Positions.resize(rows.rows(), 3);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    rows.row(i) = positions[i];
    posed.Positions.row(i) = targets[i];
  }
  uneven = shape::BuildCurveHandle(rows, true);
  const Eigen::MatrixXd one = shape::ShapeDeformation(graph, loop, InFull()).Deform(pose).Points;
  const Eigen::MatrixXd other =
    shape::ShapeDeformation(graph, uneven, InFull()).Deform(posed).Points;
  EXPECT_LT(Largest(one - other), 0.01); // edges are 0.06
}

TEST(FrontDeformation, StreamedWeightsAreTheKeptOnes)
{
  shapetest::ExpectStreamedWeightsAreTheKeptOnes<shape::FrontDeformation>(3.0);
}
