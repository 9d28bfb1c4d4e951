#include "Deform/Private/BoundaryRelative.h"
#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"
#include "Support/Deformations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using Options = shape::DeformOptions;
using shapetest::Largest;

Options Relative()
{
  Options options;
  options.Method = Options::MethodType::BoundaryRelative;
  options.Multiresolution = Options::MultiresolutionType::Off;
  return options;
}

/// Points around the curve below, as a point set.
Eigen::MatrixXd PositionsAround()
{
  Eigen::MatrixXd positions(27, 3);
  int row = 0;
  for (const double x : { -0.8, 0.1, 0.9 })
  {
    for (const double y : { -0.3, 0.7, 1.4 })
    {
      for (const double z : { 0.2, 0.5, 1.1 })
      {
        positions.row(row++) << x, y, z;
      }
    }
  }
  return positions;
}

/// An L of two segments of length 2, whose corner alone moves, with `pieces` samples on each.
shape::BoundaryHandle Corner(int pieces)
{
  Eigen::MatrixXd samples(2 * pieces + 1, 3);
  for (int i = 0; i <= pieces; ++i)
  {
    samples.row(i) << -1.0 + 2.0 * i / pieces, 0, 0;
    samples.row(pieces + i) << 1, 2.0 * i / pieces, 0;
  }
  return shape::BuildCurveHandle(samples, false);
}

/// The integrals of 1 / d^2 and s / d^2 over a segment from `from` to `to`, s from 0 to 1 along it.
Eigen::Vector2d SegmentIntegrals(
  const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Eigen::Vector3d& p)
{
  const double length = (to - from).norm();
  const Eigen::Vector3d along = (to - from) / length;
  const double foot = (p - from).dot(along);
  const double height2 = (p - from).squaredNorm() - foot * foot, height = std::sqrt(height2);
  const double plain = (std::atan((length - foot) / height) + std::atan(foot / height)) / height;
  const double far = (length - foot) * (length - foot) + height2, near = foot * foot + height2;
  return { plain, (0.5 * std::log(far / near) + foot * plain) / length };
}

} // namespace

TEST(BoundaryRelative, IsTheClosedFormOfASquaredDistanceOnAPolyline)
{
  const Eigen::MatrixXd positions = PositionsAround();
  const Eigen::RowVector3d shift(0.3, -0.5, 0.4);
  const Eigen::Vector3d a(-1, 0, 0), b(1, 0, 0), c(1, 2, 0);
  const shape::PointGraph graph = shape::BuildPointGraph({ positions, {}, {}, {} });
  double before = 1.0;
  for (const int pieces : { 20, 40, 80, 160 })
  {
    const shape::BoundaryHandle corner = Corner(pieces);
    shape::HandlePose pose = shape::GetRestPose(corner);
    for (int i = 0; i <= 2 * pieces; ++i)
    {
      pose.Positions.row(i) += (1.0 - std::abs(i - pieces) / static_cast<double>(pieces)) * shift;
    }
    const Eigen::MatrixXd moved =
      shape::ShapeDeformation(graph, corner, Relative()).Deform(pose).Points;
    double error = 0.0;
    for (int i = 0; i < positions.rows(); ++i)
    {
      const Eigen::Vector3d p = positions.row(i).transpose();
      const Eigen::Vector2d first = SegmentIntegrals(a, b, p), second = SegmentIntegrals(c, b, p);
      const double share = (first(1) + second(1)) / (first(0) + second(0));
      error = std::max(error, (moved.row(i) - positions.row(i) - share * shift).norm());
    }
    EXPECT_LT(error, pieces == 20 ? 2e-3 : before / 3.5); // of second order
    before = error;
  }
  EXPECT_LT(before, 3e-5);
}

TEST(BoundaryRelative, AnUnevenlySampledLoopGivesTheSame)
{
  const shape::Mesh cap = shapetest::Cap(12);
  const shape::PointGraph graph = shape::BuildPointGraph(cap);
  // A circle of 400 samples, evenly, and ever denser towards one place.
  const auto circle = [](bool even)
  {
    Eigen::MatrixXd positions(400, 3);
    for (int i = 0; i < 400; ++i)
    {
      const double t = i / 400.0,
                   angle = 2.0 * M_PI * (even ? t : t + 0.13 * std::sin(2.0 * M_PI * t));
      positions.row(i) << 1.2 * std::cos(angle), 1.2 * std::sin(angle), -0.2;
    }
    return shape::BuildCurveHandle(positions, true);
  };
  std::vector<Eigen::MatrixXd> results;
  for (const bool even : { true, false })
  {
    const shape::BoundaryHandle loop = circle(even);
    results.push_back(shape::ShapeDeformation(graph, loop, Relative())
                        .Deform(shape::PoseHandle(loop, shapetest::Bent(loop.Positions, 1.5)))
                        .Points);
  }
  EXPECT_GT(Largest(results[0] - cap.Points), 0.3);
  EXPECT_LT(Largest(results[0] - results[1]), 1e-3);
}

TEST(BoundaryRelative, SquashesFarPointsAndTheFrontDoesNot)
{
  // A tall cup, rim down, whose rim is bent to a cylinder.
  shape::Mesh cup = shapetest::FlatDisk(30);
  for (auto row : cup.Points.rowwise())
  {
    const double r = row.head<2>().norm(), wall = std::min(1.0, r / 0.3);
    row(2) = 3.0 * (1.0 - std::max(0.0, (r - 0.3) / 0.7));
    row.head<2>() *= r > 0.0 ? wall / r : 0.0;
  }
  const shape::BoundaryHandle rim = shapetest::LoopOf(cup);
  const shape::HandlePose pose = shape::PoseHandle(rim, shapetest::Bent(rim.Positions, 0.8));
  const auto heightOf = [&](const Options& options)
  {
    const Eigen::MatrixXd moved =
      shape::ShapeDeformation(shape::BuildPointGraph(cup), rim, options).Deform(pose).Points;
    return moved.col(2).maxCoeff() - pose.Positions.col(2).mean();
  };
  EXPECT_LT(heightOf(Relative()), 2.85);
  Options front = Relative();
  front.Method = Options::MethodType::UpwindFront;
  EXPECT_NEAR(heightOf(front), 3.0, 0.03);
}

TEST(BoundaryRelative, StreamedWeightsAreTheKeptOnes)
{
  shapetest::ExpectStreamedWeightsAreTheKeptOnes<shape::BoundaryRelative>(2.0);
}

TEST(BoundaryRelative, SourcesWithoutWeightCountByTheirDistance)
{
  const shape::Mesh cap = shapetest::Cap(10);
  shape::NodeProblem problem;
  problem.Graph = shape::BuildPointGraph(cap);
  problem.Sources = shape::FindManifoldBoundaryLoops(cap).front();
  for (const int source : problem.Sources)
  {
    problem.Graph.Weights(source) = 0.0;
  }
  problem.Powers = Eigen::VectorXd::Constant(cap.Points.rows(), 2.0);
  problem.Scales = Eigen::VectorXd::Ones(cap.Points.rows());
  const auto sources = static_cast<Eigen::Index>(problem.Sources.size());
  const Eigen::Vector3d shift(1.0, 2.0, 3.0);
  const shape::NodeTransforms motions{ shift.replicate(1, sources),
    std::vector<Eigen::Matrix3d>(sources, Eigen::Matrix3d::Identity()) };
  for (const bool streamed : { false, true })
  {
    problem.MaximumWeights = streamed ? 0 : problem.MaximumWeights;
    const shape::BoundaryRelative relative(problem);
    EXPECT_EQ(relative.ZeroWeights(), cap.Points.rows() - sources);
    const Eigen::MatrixXd shifts = relative.Move(motions, 1e9).Shifts;
    EXPECT_LT((shifts.colwise() - shift).cwiseAbs().maxCoeff(), 1e-12);
  }
}
