#include "Deform/Private/BoundaryIntegral.h"
#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using Options = shape::DeformOptions;
using shapetest::Largest;

Options Integrated(bool integrate = true)
{
  Options options;
  options.Method = Options::MethodType::BoundaryRelative;
  options.IntegrateCurves = integrate;
  options.Multiresolution = Options::MultiresolutionType::Off;
  return options;
}

/// Points around the polyline below, as a point set. Two are on the lines of its segments, but not
/// on the segments.
shape::PointGraph PointsAround()
{
  Eigen::MatrixXd positions(20, 3);
  int row = 0;
  for (const double x : { -0.8, 0.1, 0.9 })
  {
    for (const double y : { -0.3, 0.7 })
    {
      for (const double z : { 0.02, 0.5, 1.1 })
      {
        positions.row(row++) << x, y, z;
      }
    }
  }
  positions.row(row++) << -1.7, 0, 0;
  positions.row(row++) << 1, 2.9, 0.8;
  return shape::BuildPointGraph({ positions, {}, {}, {} });
}

/// A polyline and a pose of it: each segment is divided into so many equal parts, with positions
/// and frames interpolated linearly.
struct PosedPolyline
{
  shape::BoundaryHandle Handle;
  shape::HandlePose Pose;
};

PosedPolyline Polyline(int parts)
{
  Eigen::MatrixXd rest(4, 3), moved(4, 3);
  rest << -1, 0, 0, 1, 0, 0, 1, 2, 0, 1, 2, 0.9;
  moved << -1.2, 0.3, 0.1, 0.6, 0.2, -0.4, 1.3, 1.7, 0.5, 1.9, 2.2, 1.1;
  const std::vector<Eigen::Matrix3d> turns = { Eigen::Matrix3d::Identity(),
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 0.5).normalized()).toRotationMatrix(),
    Eigen::AngleAxisd(-1.2, Eigen::Vector3d(0, 1, 1).normalized()).toRotationMatrix(),
    shapetest::SomeRotation() };
  const int count = 3 * parts + 1;
  Eigen::MatrixXd samples(count, 3), targets(count, 3);
  shape::HandlePose pose;
  for (int i = 0; i < count; ++i)
  {
    const int from = std::min(i / parts, 2);
    const double s = static_cast<double>(i - from * parts) / parts;
    samples.row(i) = (1.0 - s) * rest.row(from) + s * rest.row(from + 1);
    targets.row(i) = (1.0 - s) * moved.row(from) + s * moved.row(from + 1);
    pose.Rotations.emplace_back((1.0 - s) * turns[from] + s * turns[from + 1]);
  }
  pose.Positions = targets;
  return { shape::BuildCurveHandle(samples, false), pose };
}

Eigen::MatrixXd Deformed(
  const shape::PointGraph& graph, const PosedPolyline& polyline, const Options& options)
{
  return shape::ShapeDeformation(graph, polyline.Handle, options).Deform(polyline.Pose).Points;
}

/// The integrals by Gauss-Legendre quadrature with 4 nodes on each of many equal parts.
Eigen::Vector3d Quadrature(
  const Eigen::Vector3d& first, const Eigen::Vector3d& last, double epsilon, int parts)
{
  const double nodes[2] = { 0.3399810435848563, 0.8611363115940526 };
  const double weights[2] = { 0.6521451548625461, 0.3478548451374538 };
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  for (int i = 0; i < parts; ++i)
  {
    for (int k = 0; k < 4; ++k)
    {
      const double s = (i + 0.5 + (k < 2 ? 0.5 : -0.5) * nodes[k % 2]) / parts;
      const double weight =
        0.5 * weights[k % 2] / parts / (((1.0 - s) * first + s * last).squaredNorm() + epsilon);
      sums += weight * Eigen::Vector3d(1.0 - s, s, s * (1.0 - s));
    }
  }
  return sums;
}

} // namespace

TEST(BoundaryIntegral, TheClosedFormIsTheIntegral)
{
  // Near the segment, beyond its ends on its line, far away, and with the foot at its midpoint.
  const Eigen::Vector3d first(-0.4, 0.3, 0.2), last(0.9, -0.5, 0.6);
  const Eigen::Vector3d along = last - first, across = along.unitOrthogonal();
  for (const double s : { -3.0, -0.1, 0.0, 0.3, 0.5, 1.0, 1.4, 20.0 })
  {
    for (const double height : { 0.0, 0.01, 0.3, 5.0 })
    {
      const Eigen::Vector3d point = first + s * along + height * across;
      const double epsilon = 1e-4;
      const shape::SegmentIntegrals found =
        shape::IntegrateInverseSquare(first - point, last - point, epsilon);
      const Eigen::Vector3d wanted = Quadrature(first - point, last - point, epsilon, 4000);
      const Eigen::Vector3d integrals(found.First, found.Last, found.Inner);
      EXPECT_LT((integrals - wanted).norm(), 1e-11 * wanted.norm()) << s << " " << height;
    }
  }
}

TEST(BoundaryIntegral, SumsOverSamplesConvergeToIt)
{
  // The sum is the trapezoidal rule for a smooth integrand: its error is of second order.
  const shape::PointGraph graph = PointsAround();
  const Eigen::MatrixXd exact = Deformed(graph, Polyline(1), Integrated());
  double before = 0.0;
  // The nearest point is 0.1 from the polyline, and the longest part 0.025: all parts are short.
  for (const int parts : { 80, 160, 320 })
  {
    const double error = Largest(Deformed(graph, Polyline(parts), Integrated(false)) - exact);
    if (before > 0.0)
    {
      EXPECT_LT(error, before / 3.5);
    }
    before = error;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(BoundaryIntegral, CollinearSamplesChangeNothing)
{
  const shape::PointGraph graph = PointsAround();
  const Eigen::MatrixXd coarse = Deformed(graph, Polyline(1), Integrated());
  EXPECT_GT(Largest(coarse - graph.Points), 0.3);
  for (const int parts : { 2, 7, 60 })
  {
    const Eigen::MatrixXd fine = Deformed(graph, Polyline(parts), Integrated());
    EXPECT_LT(Largest(coarse - fine), 1e-12) << parts;
  }
}

TEST(BoundaryIntegral, MotionsAndSimilaritiesAreExact)
{
  const shape::Mesh cap = shapetest::Cap(12);
  const shape::PointGraph graph = shape::BuildPointGraph(cap);
  const shape::BoundaryHandle rim = shapetest::LoopOf(cap);
  const Eigen::Matrix3d turn = shapetest::SomeRotation();
  const Eigen::RowVector3d shift(3, -1, 2);
  for (const double scale : { 1.0, 0.4, 2.5 })
  {
    Options options = Integrated();
    options.Scale = scale;
    const auto moved = [&](const Eigen::MatrixXd& points)
    { return shapetest::Moved(points, turn, scale, shift); };
    const shape::HandlePose pose = shape::PoseHandle(rim, moved(rim.Positions));
    const Eigen::MatrixXd points = shape::ShapeDeformation(graph, rim, options).Deform(pose).Points;
    EXPECT_LT(Largest(points - moved(cap.Points)), 1e-12 * shape::ComputeBoxDiagonal(points));
  }
  const Eigen::MatrixXd still =
    shape::ShapeDeformation(graph, rim, Integrated()).Deform(shape::GetRestPose(rim)).Points;
  EXPECT_EQ(still, cap.Points);
}

TEST(BoundaryIntegral, PointsAndSurfacesOfTheHandleCountAsBefore)
{
  // A segment and a point that is on no curve: the weight of the point is its square link, that of
  // the segment the strip of CurveWidth.
  const shape::PointGraph graph = PointsAround();
  Eigen::MatrixXd samples(3, 3);
  samples << -1, 0, 0, 1, 0, 0, 0.2, 3, 0.4;
  shape::BoundaryHandle handle = shape::BuildCurveHandle(samples, false);
  handle.Segments.conservativeResize(1, Eigen::NoChange);
  shape::HandlePose pose = shape::GetRestPose(handle);
  const Eigen::RowVector3d shift(0.2, 0.1, -0.7);
  pose.Positions.row(2) += shift;
  const Eigen::MatrixXd moved =
    shape::ShapeDeformation(graph, handle, Integrated()).Deform(pose).Points;
  const double edge = graph.MeanLength, epsilon = 1e-6 * edge * edge;
  for (Eigen::Index i = 0; i < moved.rows(); ++i)
  {
    const Eigen::Vector3d p = graph.Points.row(i).transpose();
    const shape::SegmentIntegrals integrals = shape::IntegrateInverseSquare(
      samples.row(0).transpose() - p, samples.row(1).transpose() - p, epsilon);
    const double curve = shape::CurveWidth * edge * 2.0 * (integrals.First + integrals.Last);
    const double point = edge * edge / ((samples.row(2).transpose() - p).squaredNorm() + epsilon);
    const Eigen::RowVector3d wanted = point / (point + curve) * shift;
    EXPECT_LT((moved.row(i) - graph.Points.row(i) - wanted).norm(), 1e-12);
  }
}

TEST(BoundaryIntegral, RefusesWhatHasNoClosedForm)
{
  const shape::PointGraph graph = PointsAround();
  const shape::BoundaryHandle curve = Polyline(4).Handle;
  const auto prepare =
    [&](const Options& options, const shape::BoundaryHandle& handle, shape::DeformFields fields)
  { shape::PrepareDeformation(graph, handle, options, fields); };
  Options soft = Integrated();
  soft.Rigidity = 0.5;
  EXPECT_REFUSED(prepare(soft, curve, {}), "rigidity 1 only", "IntegrateCurves");
  Options geodesic = Integrated();
  geodesic.Distance = Options::DistanceType::Geodesic;
  EXPECT_REFUSED(prepare(geodesic, curve, {}), "Euclidean", "IntegrateCurves");
  EXPECT_REFUSED(
    prepare(Integrated(), { curve.Positions, {}, {}, {} }, {}), "no curves", "IntegrateCurves");
  shape::DeformFields fields;
  fields.Segments = Eigen::VectorXi::Zero(graph.NodeOf.size());
  EXPECT_REFUSED(prepare(Integrated(), curve, fields), "one after another", "IntegrateCurves");
  // With the upwind front, the option has no meaning, and is not read.
  soft.Method = Options::MethodType::UpwindFront;
  EXPECT_NO_THROW(prepare(soft, curve, {}));
}
