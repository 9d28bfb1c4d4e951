#include "Base/Errors.h"
#include "Deform/HandleFrames.h"
#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"
#include "Support/Deformations.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using Options = shape::DeformOptions;
using shapetest::Bent;
using shapetest::Cap;
using shapetest::DeformWithBentLoop;
using shapetest::ElementsOf;
using shapetest::Largest;
using shapetest::LoopOf;
using shapetest::Moved;
using shapetest::SomeRotation;

/// Combinations of what changes the weights.
std::vector<Options> ManyOptions()
{
  std::vector<Options> all;
  for (const auto method :
    { Options::MethodType::UpwindFront, Options::MethodType::BoundaryRelative })
  {
    for (const auto distance :
      { Options::DistanceType::Euclidean, Options::DistanceType::Geodesic })
    {
      for (const auto resolution :
        { Options::MultiresolutionType::Off, Options::MultiresolutionType::On })
      {
        for (int k = 0; k < 3; ++k)
        {
          Options options;
          options.Method = method;
          options.Distance = distance;
          options.Multiresolution = resolution;
          options.Rigidity = k == 0 ? 1.0 : k == 1 ? 0.05 : 10.0;
          options.RigidityBy = static_cast<Options::RigidityByType>(k);
          options.UpwindRadius = k == 0 ? 2.1 : k == 1 ? 0.1 : 5.0;
          options.LaplacianSmoothing = k == 1;
          all.push_back(options);
        }
      }
    }
  }
  return all;
}

/// Some shape and a handle of it.
struct Case
{
  const char* Name;
  shape::ShapeElements Shape;
  shape::BoundaryHandle Handle;
};

/// A surface by its rim, an open curve, a patch of it and points; a solid by a side; a soup with
/// pieces that nothing joins, degenerate and non-manifold triangles and loose points; points alone.
std::vector<Case> ManyCases()
{
  const shape::Mesh cap = Cap(18); // more than 1000 points, for multiresolution
  const shape::BoundaryHandle rim = LoopOf(cap);
  std::vector<Case> cases = { { "rim", ElementsOf(cap), rim } };
  cases.push_back(
    { "open curve", ElementsOf(cap), shape::BuildCurveHandle(rim.Positions.topRows(30), false) });
  cases.push_back({ "coarse curve", ElementsOf(cap),
    shape::BuildCurveHandle(rim.Positions(std::vector<int>{ 0, 20, 25, 70 }, Eigen::all), true) });
  cases.push_back({ "points", ElementsOf(cap), { rim.Positions.topRows(5), {}, {}, {} } });
  shape::Mesh patch = cap;
  patch.Triangles = Eigen::MatrixXi(cap.Triangles.topRows(60));
  cases.push_back(
    { "patch", ElementsOf(cap), { patch.Points.topRows(100), {}, patch.Triangles, {} } });

  const shape::ShapeElements block = shapetest::Block(8, 16, 4.0);
  const shape::Mesh side = shapetest::FlatSquare(3, 0.0);
  cases.push_back({ "solid", block, { side.Points, {}, side.Triangles, {} } });

  shape::Mesh soup{ Eigen::MatrixXd(3 * cap.Triangles.rows(), 3), cap.Triangles };
  for (int t = 0; t < cap.Triangles.rows(); ++t)
  {
    soup.Points.middleRows(3 * t, 3) = shape::GetCorners(cap, t);
    soup.Triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
    if (t % 11 == 0)
    {
      soup.Points.middleRows(3 * t, 3).array() += 0.05; // off the others
    }
  }
  soup.Triangles.row(1) << 0, 1, 1;
  soup.Triangles.row(3) << 0, 0, 0;
  soup.Triangles.row(5) << 0, 1, 50;
  soup.Triangles.row(7) << 0, 1, 80;
  cases.push_back({ "soup", ElementsOf(soup), rim });
  cases.push_back({ "point set", { cap.Points, {}, {}, {} }, rim });
  return cases;
}

double RelativeError(const shape::DeformedShape& deformed, const Eigen::MatrixXd& wanted)
{
  return Largest(deformed.Points - wanted) /
    std::max(shape::ComputeBoxDiagonal(wanted), wanted.cwiseAbs().maxCoeff());
}

} // namespace

TEST(ShapeDeformation, ARigidMotionOfTheHandleIsThatOfTheShape)
{
  const Eigen::Matrix3d turn = SomeRotation();
  const Eigen::RowVector3d shift(3, -100, 2);
  for (const Case& one : ManyCases())
  {
    const shape::PointGraph graph = shape::BuildPointGraph(one.Shape);
    const shape::HandlePose pose =
      shape::PoseHandle(one.Handle, Moved(one.Handle.Positions, turn, 1.0, shift));
    for (const Options& options : ManyOptions())
    {
      const shape::DeformedShape deformed =
        shape::ShapeDeformation(graph, one.Handle, options).Deform(pose);
      EXPECT_LT(RelativeError(deformed, Moved(one.Shape.Points, turn, 1.0, shift)), 1e-12)
        << one.Name;
      for (const Eigen::Matrix3d& rotation : deformed.Rotations)
      {
        EXPECT_LT((rotation - turn).norm(), 1e-12) << one.Name;
      }
    }
  }
}

TEST(ShapeDeformation, AHandleScaledByScaleIsASimilarity)
{
  const Eigen::Matrix3d turn = SomeRotation();
  const Eigen::RowVector3d shift(3, -1, 2);
  for (const Case& one : ManyCases())
  {
    const shape::PointGraph graph = shape::BuildPointGraph(one.Shape);
    const shape::HandlePose pose =
      shape::PoseHandle(one.Handle, Moved(one.Handle.Positions, turn, 1.7, shift));
    for (Options options : ManyOptions())
    {
      options.Scale = 1.7;
      EXPECT_LT(RelativeError(shape::ShapeDeformation(graph, one.Handle, options).Deform(pose),
                  Moved(one.Shape.Points, turn, 1.7, shift)),
        1e-12)
        << one.Name;
    }
  }
}

TEST(ShapeDeformation, AnUnmovedHandleReturnsThePointsThemselves)
{
  for (Case one : ManyCases())
  {
    const Eigen::RowVector3d off(0.3, 17.1, 4.7);
    one.Shape.Points.rowwise() += off;
    one.Handle.Positions.rowwise() += off;
    const shape::PointGraph graph = shape::BuildPointGraph(one.Shape);
    for (const Options& options : ManyOptions())
    {
      const shape::ShapeDeformation prepared(graph, one.Handle, options);
      EXPECT_EQ(prepared.Deform(shape::PoseHandle(one.Handle, one.Handle.Positions)).Points,
        one.Shape.Points)
        << one.Name;
    }
  }
}

TEST(ShapeDeformation, PointsOnTheHandleFollowItExactly)
{
  const shape::Mesh cap = Cap(20);
  const shape::BoundaryHandle rim = LoopOf(cap);
  const std::vector<int> loop = shape::FindManifoldBoundaryLoops(cap).front();
  // Every fifth sample: the points between them are on the segments of a polygon.
  std::vector<int> few;
  for (int i = 0; i < static_cast<int>(loop.size()); i += 5)
  {
    few.push_back(i);
  }
  const shape::PointGraph graph = shape::BuildPointGraph(cap);
  const Eigen::MatrixXd target = Bent(rim.Positions, 1.0);
  for (const Options& options : ManyOptions())
  {
    const Eigen::MatrixXd moved =
      shape::ShapeDeformation(graph, rim, options).Deform(shape::PoseHandle(rim, target)).Points;
    EXPECT_LT(Largest(moved(loop, Eigen::all) - target), 1e-14);
  }
  shape::Mesh square = shapetest::FlatSquare(20, 0.2);
  Eigen::MatrixXd corners(4, 3);
  corners << -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0;
  const shape::BoundaryHandle frame = shape::BuildCurveHandle(corners, true);
  Eigen::MatrixXd skew = corners;
  skew.row(2) += Eigen::RowVector3d(0.5, 0.2, 0.7);
  const Eigen::MatrixXd moved = shape::ShapeDeformation(shape::BuildPointGraph(square), frame)
                                  .Deform(shape::PoseHandle(frame, skew))
                                  .Points;
  for (int i = 0; i < square.Points.rows(); ++i)
  {
    if (std::abs(square.Points(i, 0) - 1.0) < 1e-12) // between the corners 1 and 2
    {
      const double t = 0.5 * (square.Points(i, 1) + 1.0);
      EXPECT_LT((moved.row(i) - (1.0 - t) * skew.row(1) - t * skew.row(2)).norm(), 1e-12);
    }
  }
}

TEST(ShapeDeformation, ReachStopsEarlyAndChangesNothingBefore)
{
  const shape::Mesh cap = Cap(18);
  const shape::BoundaryHandle rim = LoopOf(cap);
  const shape::PointGraph graph = shape::BuildPointGraph(cap);
  const shape::HandlePose pose = shape::PoseHandle(rim, Bent(rim.Positions, 1.0));
  for (const Options& options : ManyOptions())
  {
    const shape::ShapeDeformation prepared(graph, rim, options);
    const Eigen::MatrixXd all = prepared.Deform(pose).Points;
    const double reach = 0.15;
    const Eigen::MatrixXd near = prepared.Deform(pose, reach).Points;
    int reached = 0;
    for (int i = 0; i < all.rows(); ++i)
    {
      if (prepared.Arrivals()(i) <= reach)
      {
        EXPECT_EQ(near.row(i), all.row(i));
        ++reached;
      }
    }
    EXPECT_GT(reached, 150);
    EXPECT_LT(reached, 500);
  }
}

TEST(ShapeDeformation, FramesOfTheHandleTurnTheShape)
{
  // All frames turned by one angle about the tangents, by the right-hand rule: inwards is up.
  const shape::Mesh cap = Cap(14);
  const shape::BoundaryHandle rim = LoopOf(cap);
  const shape::ShapeDeformation prepared(shape::BuildPointGraph(cap), rim);
  double before = -1.0;
  for (const double angle : { -0.6, -0.3, 0.0, 0.3, 0.6 })
  {
    shape::HandlePose pose = shape::GetRestPose(rim);
    shape::RotateAboutTangents(rim, Eigen::VectorXd::Constant(rim.Positions.rows(), angle), pose);
    const double height = prepared.Deform(pose).Points.col(2).maxCoeff();
    EXPECT_GT(height, before);
    before = height;
  }
}

TEST(ShapeDeformation, CountsWhatItMeets)
{
  for (const Case& one : ManyCases())
  {
    const shape::DeformFacts facts =
      shape::ShapeDeformation(shape::BuildPointGraph(one.Shape), one.Handle).Facts();
    const bool soup = std::string(one.Name) == "soup";
    EXPECT_EQ(facts.Islands > 10, soup) << one.Name;
    EXPECT_EQ(facts.WeldedPoints > 0, soup) << one.Name;
    EXPECT_EQ(facts.BasePoints, 0) << one.Name; // not so many points
  }
  Options options;
  options.UpwindRadius = 0.01;
  const shape::Mesh cap = Cap(40);
  shape::DeformFacts facts =
    shape::ShapeDeformation(shape::BuildPointGraph(cap), LoopOf(cap), options).Facts();
  EXPECT_GT(facts.EmptyBands, 300);
  EXPECT_GT(facts.BasePoints, 1000);
  // All triangles degenerate: nothing has a weight.
  shape::Mesh line = shapetest::FlatSquare(4, 0.0);
  line.Points.col(1).setZero();
  line.Points.col(0) += Eigen::VectorXd::LinSpaced(25, 0.0, 0.01);
  const shape::BoundaryHandle end = { line.Points.topRows(1), {}, {}, {} };
  const shape::ShapeDeformation prepared(shape::BuildPointGraph(line), end);
  EXPECT_GT(prepared.Facts().ZeroWeights, 0);
  const shape::DeformedShape deformed = prepared.Deform({ end.Positions, { SomeRotation() } });
  EXPECT_TRUE(deformed.Points.allFinite());
}

TEST(ShapeDeformation, OpposedFramesAndCollapsedHandlesStayFinite)
{
  const shape::Mesh cap = Cap(10);
  const shape::BoundaryHandle rim = LoopOf(cap);
  const shape::ShapeDeformation prepared(shape::BuildPointGraph(cap), rim);
  shape::HandlePose pose = shape::GetRestPose(rim);
  for (std::size_t i = 0; i < pose.Rotations.size(); i += 2)
  {
    pose.Rotations[i] = Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  }
  pose.Positions.rowwise() = Eigen::RowVector3d(1, 2, 3);
  const shape::DeformedShape deformed = prepared.Deform(pose);
  EXPECT_TRUE(deformed.Points.allFinite());
  for (const Eigen::Matrix3d& rotation : deformed.Rotations)
  {
    EXPECT_LT((rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-12);
  }
}

TEST(ShapeDeformation, ExtremesAreDefined)
{
  const shape::Mesh cap = Cap(6);
  const shape::BoundaryHandle rim = LoopOf(cap);
  const Eigen::Matrix3d turn = SomeRotation();
  const auto isRigid = [&](const Eigen::MatrixXd& points, const shape::BoundaryHandle& handle)
  {
    const Eigen::RowVector3d shift(1, 2, 3);
    const shape::ShapeDeformation prepared(shape::BuildPointGraph({ points, {}, {}, {} }), handle);
    shape::HandlePose pose{ Moved(handle.Positions, turn, 1.0, shift),
      std::vector<Eigen::Matrix3d>(handle.Positions.rows(), turn) };
    EXPECT_LT(RelativeError(prepared.Deform(pose), Moved(points, turn, 1.0, shift)), 1e-12);
  };
  isRigid(Eigen::RowVector3d(0.1, 0.2, 0.3), rim);                 // one point
  isRigid(Eigen::RowVector3d(0.1, 0.2, 0.3).replicate(5, 1), rim); // all at one place
  isRigid(cap.Points, { cap.Points.topRows(1), {}, {}, {} });      // one sample
  isRigid(cap.Points, { cap.Points.topRows(1).replicate(4, 1), {}, {}, {} });
  isRigid(cap.Points, shape::BuildCurveHandle(rim.Positions * 1e3, true));  // large and far
  isRigid(cap.Points, shape::BuildCurveHandle(rim.Positions * 1e-9, true)); // in one spot
  isRigid(rim.Positions, rim); // nothing but the handle
  isRigid(Eigen::RowVector3d(1e6, 0, 0).replicate(3, 1), rim);
  // A unit of length more or less changes nothing.
  const Eigen::MatrixXd target = Bent(rim.Positions, 1.0);
  const Eigen::MatrixXd one = DeformWithBentLoop(cap, {});
  for (const double unit : { 1e-12, 1e12 })
  {
    shape::BoundaryHandle scaled = rim;
    scaled.Positions *= unit;
    const shape::ShapeDeformation prepared(
      shape::BuildPointGraph(shape::Mesh{ cap.Points * unit, cap.Triangles }), scaled);
    EXPECT_LT(
      Largest(prepared.Deform(shape::PoseHandle(scaled, target * unit)).Points / unit - one), 1e-6);
  }
}

TEST(ShapeDeformation, TheSameInputGivesTheSameBits)
{
  const shape::Mesh cap = Cap(40);
  EXPECT_EQ(DeformWithBentLoop(cap, {}), DeformWithBentLoop(cap, {}));
}

TEST(ShapeDeformation, NamesWhatIsWrong)
{
  const shape::Mesh cap = Cap(4);
  const shape::PointGraph graph = shape::BuildPointGraph(cap);
  const shape::BoundaryHandle rim = LoopOf(cap);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  shapetest::ExpectRefused<Options>(
    [&](const Options& options) { shape::ShapeDeformation(graph, rim, options); }, {},
    { { &Options::Rigidity, 0.0, { "Rigidity is 0" } },
      { &Options::Scale, -1.0, { "Scale is -1" } },
      { &Options::InnerScale, 0.0, { "InnerScale is 0" } },
      { &Options::UpwindRadius, nan, { "UpwindRadius is nan" } },
      { &Options::RigidityContrast, infinity, { "RigidityContrast is inf" } } });
  const auto refusesFields = [&](const shape::DeformFields& fields)
  { EXPECT_THROW(shape::ShapeDeformation(graph, rim, {}, fields), shape::InvalidInput); };
  refusesFields({ Eigen::VectorXd::Ones(3), {}, {} });
  refusesFields({ {}, Eigen::VectorXd::Constant(cap.Points.rows(), -1.0), {} });
  refusesFields({ {}, {}, Eigen::VectorXi::Zero(7) });
  EXPECT_THROW(shape::ShapeDeformation(graph, {}), shape::InvalidInput);
  shape::BoundaryHandle wrong = rim;
  wrong.Segments(0, 1) = 1000;
  EXPECT_THROW(shape::ShapeDeformation(graph, wrong), shape::InvalidInput);
  wrong = rim;
  wrong.Positions(2, 2) = NAN;
  EXPECT_THROW(shape::ShapeDeformation(graph, wrong), shape::InvalidInput);
  wrong = rim; // far from the shape, which would be one point beside it
  wrong.Positions(2, 2) = 1e12;
  EXPECT_THROW(shape::ShapeDeformation(graph, wrong), shape::InvalidInput);
  const shape::ShapeDeformation prepared(graph, rim);
  shape::HandlePose pose = shape::GetRestPose(rim);
  pose.Rotations.pop_back();
  EXPECT_THROW(prepared.Deform(pose), shape::InvalidInput);
  EXPECT_THROW(
    shape::ShapeDeformation(graph, rim, {}, {}, shape::Progress([](double) { return false; })),
    shape::Aborted);
}

TEST(ShapeDeformation, SliversOfTheHandleAreSampledByTheirArea)
{
  // A fine square, and a triangle of the handle that is a thousand times as long as it is wide.
  shape::Mesh square = shapetest::FlatSquare(20, 0.0);
  square.Points *= 1e-4;
  shape::BoundaryHandle sliver;
  sliver.Positions = Eigen::MatrixXd(3, 3);
  sliver.Positions << 0, 0, 0, 1, 0, 0, 0.5, 1e-3, 0;
  sliver.Triangles = Eigen::MatrixXi(1, 3);
  sliver.Triangles << 0, 1, 2;
  const shape::ShapeDeformation prepared(shape::BuildPointGraph(square), sliver);
  const Eigen::MatrixXd moved = prepared.Deform(shape::GetRestPose(sliver)).Points;
  EXPECT_LT((moved - square.Points).cwiseAbs().maxCoeff(), 1e-12);
}
