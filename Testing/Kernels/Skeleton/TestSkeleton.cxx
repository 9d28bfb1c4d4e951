#include "Skeleton/Skeleton.h"
#include "Support/LimbShapes.h"
#include "Support/ProgressChecks.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <random>

namespace
{

using Eigen::RowVector3d;
using shape::CurveSkeleton;

int CountDegree(const CurveSkeleton& skeleton, int degree)
{
  return static_cast<int>((skeleton.Degrees.array() == degree).count());
}

/// The longest distance from points of a skeleton to the nearest points of another.
double Distance(const CurveSkeleton& a, const Eigen::MatrixXd& b)
{
  double longest = 0.0;
  for (const auto& point : a.Points.rowwise())
  {
    longest = std::max(longest, (b.rowwise() - point).rowwise().norm().minCoeff());
  }
  return longest;
}

shape::Mesh Capsule(double spacing = 0.05)
{
  return shapetest::Union({ { { 0, 0, 0 }, { 4, 0, 0 }, 0.5, 0.5 } }, spacing);
}

/// The same surface with its points and triangles in another order.
shape::Mesh Shuffled(const shape::Mesh& mesh)
{
  std::vector<int> points(mesh.Points.rows()), triangles(mesh.Triangles.rows());
  std::iota(points.begin(), points.end(), 0);
  std::iota(triangles.begin(), triangles.end(), 0);
  std::mt19937 generator(7);
  std::shuffle(points.begin(), points.end(), generator);
  std::shuffle(triangles.begin(), triangles.end(), generator);
  shape::Mesh result = mesh;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result.Points.row(points[i]) = mesh.Points.row(static_cast<Eigen::Index>(i));
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      result.Triangles(triangles[t], k) =
        points[mesh.Triangles(static_cast<Eigen::Index>(t), (k + 1) % 3)];
    }
  }
  return result;
}

} // namespace

TEST(Skeleton, OfACapsuleIsItsAxis)
{
  const CurveSkeleton skeleton = shape::ExtractCurveSkeleton(Capsule());
  ASSERT_EQ(skeleton.Branches.size(), 1U);
  EXPECT_EQ(skeleton.Cycles, 0);
  EXPECT_EQ(skeleton.OutsidePoints, 0);
  EXPECT_EQ(CountDegree(skeleton, 1), 2);
  // On the axis within a tenth of an edge, with the radius of the capsule there.
  EXPECT_LT(skeleton.Points.rightCols(2).rowwise().norm().maxCoeff(), 0.005);
  EXPECT_NEAR(skeleton.Points.col(0).minCoeff(), 0.0, 0.15);
  EXPECT_NEAR(skeleton.Points.col(0).maxCoeff(), 4.0, 0.15);
  EXPECT_NEAR(skeleton.Radii.minCoeff(), 0.5, 0.01);
  EXPECT_NEAR(skeleton.Radii.maxCoeff(), 0.5, 0.01);
}

TEST(Skeleton, HasEdgesAsLongAsTheResolution)
{
  shape::CurveSkeletonOptions options;
  options.Resolution = 0.2;
  const CurveSkeleton skeleton = shape::ExtractCurveSkeleton(Capsule(), options);
  const std::vector<int>& branch = skeleton.Branches.at(0);
  for (std::size_t i = 1; i < branch.size(); ++i)
  {
    EXPECT_NEAR(
      (skeleton.Points.row(branch[i]) - skeleton.Points.row(branch[i - 1])).norm(), 0.2, 0.02);
  }
}

TEST(Skeleton, OfATorusIsItsCircle)
{
  const CurveSkeleton skeleton = shape::ExtractCurveSkeleton(shapetest::Torus(1.0, 0.3, 60, 24));
  ASSERT_EQ(skeleton.Branches.size(), 1U);
  EXPECT_EQ(skeleton.Branches[0].front(), skeleton.Branches[0].back());
  EXPECT_EQ(skeleton.Cycles, 1);
  EXPECT_EQ(CountDegree(skeleton, 2), skeleton.Points.rows());
  const Eigen::VectorXd radii = skeleton.Points.leftCols(2).rowwise().norm();
  EXPECT_NEAR(radii.minCoeff(), 1.0, 0.03);
  EXPECT_NEAR(radii.maxCoeff(), 1.0, 0.03);
  EXPECT_LT(skeleton.Points.col(2).cwiseAbs().maxCoeff(), 0.01);
}

TEST(Skeleton, HasTheGenusOfADoubleTorus)
{
  // Two rings with a common bar.
  std::vector<shapetest::Limb> limbs =
    shapetest::Chain({ { 0, -1, 0 }, { -1.5, -1, 0 }, { -1.5, 1, 0 }, { 0, 1, 0 }, { 1.5, 1, 0 },
                       { 1.5, -1, 0 }, { 0, -1, 0 }, { 0, 1, 0 } },
      0.25);
  const CurveSkeleton skeleton = shape::ExtractCurveSkeleton(shapetest::Union(limbs, 0.06));
  EXPECT_EQ(skeleton.Cycles, 2);
  EXPECT_EQ(skeleton.Branches.size(), 3U);
  EXPECT_EQ(CountDegree(skeleton, 3), 2);
  EXPECT_EQ(CountDegree(skeleton, 1), 0);
}

TEST(Skeleton, OfThreeLimbsHasAJunctionOfThreeBranches)
{
  const CurveSkeleton skeleton =
    shape::ExtractCurveSkeleton(shapetest::Union(shapetest::Star({ 2, 2.5, 3 }, 0.3), 0.06));
  ASSERT_EQ(skeleton.Branches.size(), 3U);
  EXPECT_EQ(CountDegree(skeleton, 1), 3);
  ASSERT_EQ(CountDegree(skeleton, 3), 1);
  Eigen::Index junction = 0;
  skeleton.Degrees.maxCoeff(&junction);
  EXPECT_LT(skeleton.Points.row(junction).norm(), 0.15);
}

TEST(Skeleton, OfAHandHasABranchForEachFinger)
{
  const CurveSkeleton skeleton = shape::ExtractCurveSkeleton(shapetest::Hand(0.0, 0.04));
  EXPECT_EQ(CountDegree(skeleton, 1), 6); // five fingers and the wrist
  EXPECT_EQ(skeleton.Cycles, 0);
  EXPECT_EQ(skeleton.OutsidePoints, 0);
}

TEST(Skeleton, HasAComponentForEachOfTheSurface)
{
  const CurveSkeleton skeleton =
    shape::ExtractCurveSkeleton(shapetest::Joined({ shapetest::Torus(1.0, 0.3, 40, 16),
      shapetest::Sphere(3, 0.5, { 4, 0, 0 }), shapetest::Shifted(Capsule(0.1), { 0, 3, 0 }) }));
  EXPECT_EQ(skeleton.Components, 3);
  EXPECT_EQ(skeleton.Cycles, 1);
}

TEST(Skeleton, DoesNotDependOnNumbers)
{
  const shape::Mesh mesh = shapetest::Union(shapetest::Star({ 2, 2.5, 3 }, 0.3), 0.08);
  const CurveSkeleton one = shape::ExtractCurveSkeleton(mesh),
                      two = shape::ExtractCurveSkeleton(Shuffled(mesh));
  EXPECT_EQ(one.Branches, two.Branches);
  EXPECT_EQ(one.Points, two.Points); // the same bits
}

TEST(Skeleton, TurnsAndGrowsWithTheShape)
{
  const shape::Mesh mesh = shapetest::Union(shapetest::Star({ 2, 2.5, 3 }, 0.3), 0.08);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const RowVector3d shift(10, -5, 3);
  const double scale = 1000.0;
  shape::Mesh moved = mesh;
  moved.Points = (scale * mesh.Points * turn.transpose()).rowwise() + shift;
  shape::CurveSkeletonOptions options;
  options.Resolution = 0.06;
  const CurveSkeleton one = shape::ExtractCurveSkeleton(mesh, options);
  options.Resolution *= scale;
  const CurveSkeleton two = shape::ExtractCurveSkeleton(moved, options);
  const Eigen::MatrixXd expected = (scale * one.Points * turn.transpose()).rowwise() + shift;
  EXPECT_EQ(one.Branches.size(), two.Branches.size());
  EXPECT_LT(Distance(two, expected), 0.06 * scale);
}

TEST(Skeleton, RefusesWhatHasNoCurveSkeleton)
{
  const shape::Mesh ball = shapetest::Sphere(2, 1.0);
  EXPECT_REFUSED(shape::ExtractCurveSkeleton(shapetest::WithoutLast(ball)), "open", "close");
  EXPECT_REFUSED(
    shape::ExtractCurveSkeleton(shapetest::Joined({ ball, shapetest::Sphere(2, 0.4) })), "void",
    "remove the inner surface");
  shapetest::ExpectRefused<shape::CurveSkeletonOptions>(
    [&](const auto& options) { shape::ExtractCurveSkeleton(ball, options); }, {},
    { { &shape::CurveSkeletonOptions::Resolution, -1.0, { "Resolution is -1" } },
      { &shape::CurveSkeletonOptions::VelocityWeight, 0.0, { "Velocity Weight is 0" } },
      { &shape::CurveSkeletonOptions::MedialWeight, -1.0, { "Medial Weight is -1" } } });
}

TEST(Skeleton, ReportsProgressAndStops)
{
  const shape::Mesh mesh = Capsule(0.1);
  const auto call = [&](const shape::Progress& progress)
  { shape::ExtractCurveSkeleton(mesh, {}, progress); };
  shapetest::ExpectProgressRises(call);
  shapetest::ExpectStopsAt(5, call);
}
