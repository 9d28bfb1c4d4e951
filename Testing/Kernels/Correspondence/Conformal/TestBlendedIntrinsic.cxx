#include "Base/Errors.h"
#include "Correspondence/Conformal/BlendedIntrinsic.h"
#include "Correspondence/Conformal/Private/MapGroups.h"
#include "Correspondence/Conformal/Private/MoebiusMap.h"
#include "Correspondence/Conformal/Private/SampleTriples.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

using shapetest::ReadModel;

/// The surface without the triangles of some of its points, and without those points.
shape::Mesh Without(const shape::Mesh& mesh, const Eigen::Array<bool, Eigen::Dynamic, 1>& cut)
{
  std::vector<int> kept, points;
  Eigen::VectorXi position = Eigen::VectorXi::Constant(mesh.Points.rows(), -1);
  for (int t = 0; t < static_cast<int>(mesh.Triangles.rows()); ++t)
  {
    const auto corners = mesh.Triangles.row(t);
    if (!cut(corners(0)) && !cut(corners(1)) && !cut(corners(2)))
    {
      kept.push_back(t);
      for (const int corner : corners)
      {
        if (position(corner) < 0)
        {
          position(corner) = static_cast<int>(points.size());
          points.push_back(corner);
        }
      }
    }
  }
  return { mesh.Points(points, Eigen::all),
    mesh.Triangles(kept, Eigen::all).unaryExpr([&](int i) { return position(i); }) };
}

shape::BlendedIntrinsicOptions OfTriplets()
{
  shape::BlendedIntrinsicOptions options;
  options.CandidatesFrom = shape::BlendedIntrinsicOptions::CandidatesType::Triplets;
  return options;
}

/// A sphere with three equal lobes around the z axis, and a top that differs from the bottom.
shape::Mesh ThreeLobes()
{
  shape::Mesh mesh = shapetest::Icosphere(4);
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const Eigen::RowVector3d p = mesh.Points.row(i);
    mesh.Points.row(i) *= 1.0 + 0.4 * (p(0) * p(0) - 3.0 * p(1) * p(1)) * p(0) + 0.3 * p(2);
  }
  return mesh;
}

int Nearest(const shape::Mesh& mesh, const Eigen::RowVector3d& position)
{
  Eigen::Index nearest = 0;
  (mesh.Points.rowwise() - position).rowwise().norm().minCoeff(&nearest);
  return static_cast<int>(nearest);
}

} // namespace

TEST(BlendedIntrinsic, ComplexPointsKeepThePlacesOfTheSphere)
{
  const Eigen::MatrixXd sphere = shapetest::Icosphere(3).Points;
  EXPECT_LT(
    (shape::ToSphere(shape::ToComplexPoints(sphere)) - sphere).cwiseAbs().maxCoeff(), 1e-14);
  Eigen::MatrixXd poles(4, 3);
  poles << 0, 0, 1, 0, 0, -1, 1e-12, 0, 1, 0, 1e-12, -1;
  EXPECT_LT((shape::ToSphere(shape::ToComplexPoints(poles)) - poles).cwiseAbs().maxCoeff(), 1e-20);
}

TEST(BlendedIntrinsic, ThreePointsMakeTheMoebiusMap)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const shape::ComplexPoints points = shape::ToComplexPoints(sphere.Points);
  const auto through = [&](int a, int b, int c, int d, int e, int f)
  {
    return shape::SolveMoebiusTransform(
      points(Eigen::Vector3i(a, b, c), Eigen::all), points(Eigen::Vector3i(d, e, f), Eigen::all));
  };
  // To themselves: the identity.
  EXPECT_LT(
    (shape::ToSphere(shape::ApplyMoebiusTransform(points, through(3, 70, 500, 3, 70, 500))) -
      sphere.Points)
      .cwiseAbs()
      .maxCoeff(),
    1e-12);
  // To others: they arrive, there and back is the identity, and both are one map after the other.
  const Eigen::Matrix2cd there = through(3, 70, 500, 8, 900, 41);
  const Eigen::MatrixXd moved = shape::ToSphere(shape::ApplyMoebiusTransform(points, there));
  EXPECT_LT((moved.row(3) - sphere.Points.row(8)).norm(), 1e-12);
  EXPECT_LT((moved.row(70) - sphere.Points.row(900)).norm(), 1e-12);
  EXPECT_LT((moved.row(500) - sphere.Points.row(41)).norm(), 1e-12);
  const Eigen::Matrix2cd both = through(8, 900, 41, 3, 70, 500) * there;
  EXPECT_LT((shape::ToSphere(shape::ApplyMoebiusTransform(points, both)) - sphere.Points)
              .cwiseAbs()
              .maxCoeff(),
    1e-11);
  // Nothing is turned over, and areas grow as is said.
  const Eigen::VectorXd scales = shape::ComputeLogAreaScales(points, there);
  double worst = 0.0;
  for (Eigen::Index t = 0; t < sphere.Triangles.rows(); ++t)
  {
    const Eigen::Vector3i corners = sphere.Triangles.row(t);
    const Eigen::Matrix3d before = sphere.Points(corners, Eigen::all),
                          after = moved(corners, Eigen::all);
    EXPECT_GT(after.determinant(), 0.0);
    const shape::Mesh one{ before, Eigen::RowVector3i(0, 1, 2) },
      other{ after, Eigen::RowVector3i(0, 1, 2) };
    const double grown =
      std::log(shape::ComputeAreaVectors(other).norm() / shape::ComputeAreaVectors(one).norm());
    worst = std::max(worst, std::abs(grown - scales(corners).mean()));
  }
  EXPECT_LT(worst, 0.05);
  EXPECT_FALSE(through(3, 3, 500, 8, 900, 41).allFinite()); // two are the same
}

TEST(BlendedIntrinsic, ACopyIsMappedOntoItself)
{
  const shape::Mesh a = ReadModel("bull");
  const shapetest::Renumbered copy = shapetest::Renumber(a, 4);
  shape::Mesh b = copy.Mesh;
  const Eigen::Matrix3d turn = shapetest::Rotation(2.0, { 1, 2, 3 });
  b.Points = 2.0 * b.Points * turn.transpose();
  const Eigen::MatrixXd wanted = 2.0 * a.Points * turn.transpose();
  // No landmark says which side is which.
  const shape::SurfaceMaps maps = shape::ComputeBlendedIntrinsicMap(a, b, {}).Maps;
  EXPECT_LT(shapetest::MapErrors(maps.AToB, b, wanted).mean(), 0.005);
  Eigen::MatrixXd back(b.Points.rows(), 3);
  back(copy.NewOf, Eigen::all) = a.Points;
  EXPECT_LT(shapetest::MapErrors(maps.BToA, a, back).mean(), 0.005);
}

TEST(BlendedIntrinsic, FindsTheSameSurfaceInOtherTrianglesAlsoWithHoles)
{
  shape::Mesh a = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  shape::Mesh b = shapetest::BumpySphere(4, shapetest::Rotation(0.7, { 3, -1, 1 }));
  for (const bool hasHole : { false, true })
  {
    if (hasHole)
    {
      const auto isCut = [](const shape::Mesh& mesh)
      {
        return (mesh.Points.rowwise() - Eigen::RowVector3d(-0.8, 0.2, -0.5))
                 .rowwise()
                 .norm()
                 .array() < 0.4;
      };
      a = Without(a, isCut(a));
      b = Without(b, isCut(b));
    }
    shape::Landmarks landmarks;
    for (const Eigen::RowVector3d& tip : { Eigen::RowVector3d(2.4, 0, 0),
           Eigen::RowVector3d(-0.85, 1.9, 0), Eigen::RowVector3d(0.23, -1.16, -1.85) })
    {
      Eigen::Index i = 0, j = 0;
      (a.Points.rowwise() - tip).rowwise().norm().minCoeff(&i);
      (b.Points.rowwise() - tip).rowwise().norm().minCoeff(&j);
      landmarks.push_back({ static_cast<int>(i), static_cast<int>(j) });
    }
    const shape::SurfaceMaps maps = shape::ComputeBlendedIntrinsicMap(a, b, landmarks).Maps;
    EXPECT_LT(shapetest::MapErrors(maps.AToB, b, a.Points).mean(), 0.02) << hasHole;
    EXPECT_LT(shapetest::MapErrors(maps.BToA, a, b.Points).mean(), 0.02) << hasHole;
    // One wrong landmark does not spoil what others agree on.
    Eigen::Index tip = 0;
    (a.Points.rowwise() - Eigen::RowVector3d(-0.95, -1.15, 1.15)).rowwise().norm().minCoeff(&tip);
    Eigen::Index tipB = 0;
    (b.Points.rowwise() - a.Points.row(tip)).rowwise().norm().minCoeff(&tipB);
    landmarks.push_back({ static_cast<int>(tip), static_cast<int>(tipB) });
    Eigen::Index top = 0, bottom = 0;
    (a.Points.rowwise() - Eigen::RowVector3d(0.35, 0.5, 1.6)).rowwise().norm().minCoeff(&top);
    (b.Points.rowwise() - Eigen::RowVector3d(0.0, 0.7, -0.8)).rowwise().norm().minCoeff(&bottom);
    landmarks.push_back({ static_cast<int>(top), static_cast<int>(bottom) });
    const shape::SurfaceMaps voted = shape::ComputeBlendedIntrinsicMap(a, b, landmarks).Maps;
    EXPECT_LT(shapetest::MapErrors(voted.AToB, b, a.Points).mean(), 0.04) << hasHole;
  }
}

TEST(BlendedIntrinsic, TheOrderOfPointsDoesNotChangeTheMapOfASheet)
{
  shape::Mesh sheet = shapetest::FlatDisk(8);
  for (Eigen::Index i = 0; i < sheet.Points.rows(); ++i)
  {
    const double x = sheet.Points(i, 0), y = sheet.Points(i, 1);
    sheet.Points.row(i) << 1.4 * x, y, 0.3 * x * x + 0.2 * x * y + 0.1 * y;
  }
  for (unsigned int seed = 0; seed < 6; ++seed)
  {
    const shapetest::Renumbered copy = shapetest::Renumber(sheet, seed);
    shape::Landmarks landmarks;
    for (int i = 0; i < static_cast<int>(sheet.Points.rows()); i += 37)
    {
      landmarks.push_back({ i, copy.NewOf(i) });
    }
    const shape::SurfaceMaps maps =
      shape::ComputeBlendedIntrinsicMap(sheet, copy.Mesh, landmarks).Maps;
    EXPECT_LT(shapetest::MapErrors(maps.AToB, copy.Mesh, sheet.Points).mean(), 1e-6) << seed;
  }
}

TEST(BlendedIntrinsic, TripletsNeedNoLandmarksAndNoOrderOfPoints)
{
  const shape::Mesh a = ReadModel("bull");
  const Eigen::Matrix3d turn = shapetest::Rotation(2.0, { 1, 2, 3 });
  const shapetest::Renumbered copy = shapetest::Renumber(a, 4);
  shape::Mesh b = copy.Mesh;
  b.Points = 2.0 * b.Points * turn.transpose();
  const Eigen::MatrixXd wanted = 2.0 * a.Points * turn.transpose();
  const shape::BlendedIntrinsicResult result =
    shape::ComputeBlendedIntrinsicMap(a, b, {}, OfTriplets());
  EXPECT_LT(shapetest::MapErrors(result.Maps.AToB, b, wanted).mean(), 0.005);
  Eigen::MatrixXd back(b.Points.rows(), 3);
  back(copy.NewOf, Eigen::all) = a.Points;
  EXPECT_LT(shapetest::MapErrors(result.Maps.BToA, a, back).mean(), 0.005);
  for (const Eigen::VectorXd& confidence : { result.ConfidenceOfA, result.ConfidenceOfB })
  {
    EXPECT_GE(confidence.minCoeff(), 0.0);
    EXPECT_LE(confidence.maxCoeff(), 1.0 + 1e-12);
    EXPECT_GT(confidence.mean(), 0.8);
  }
  const Eigen::Index count = result.Weights.size();
  ASSERT_EQ(result.Consistency.rows(), count);
  ASSERT_EQ(result.TriplesOfA.rows(), count);
  EXPECT_EQ(result.Consistency, result.Consistency.transpose());
  EXPECT_GE(result.Consistency.minCoeff(), 0.0);
  EXPECT_LE(result.Consistency.maxCoeff(), 1.0 + 1e-12);
  EXPECT_NEAR(result.Weights.norm(), 1.0, 1e-12);
  // The identity's triples are among the candidates, and those with a weight are nearly it.
  int same = 0;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Eigen::RowVector3i ofA = result.TriplesOfA.row(i);
    const bool isSame = copy.NewOf(ofA) == result.TriplesOfB.row(i).transpose();
    same += isSame ? 1 : 0;
    EXPECT_TRUE(!isSame || result.Weights(i) > 0.0);
  }
  EXPECT_GT(same, 20);
}

// Any turn by a third around the axis is an isometry, and only landmarks tell which one is wanted.
TEST(BlendedIntrinsic, LandmarksSelectTheSymmetry)
{
  const shape::Mesh mesh = ThreeLobes();
  for (const int third : { 0, 1, 2 })
  {
    const Eigen::Matrix3d turn =
      shapetest::Rotation(third * 2.0 * std::acos(-1.0) / 3.0, { 0, 0, 1 });
    const Eigen::MatrixXd wanted = mesh.Points * turn.transpose();
    shape::Landmarks landmarks;
    for (const Eigen::RowVector3d& tip :
      { Eigen::RowVector3d(1.4, 0.0, 0.0), Eigen::RowVector3d(0.0, 0.0, 1.3) })
    {
      const int point = Nearest(mesh, tip);
      landmarks.push_back({ point, Nearest(mesh, wanted.row(point)) });
    }
    const shape::BlendedIntrinsicResult result =
      shape::ComputeBlendedIntrinsicMap(mesh, mesh, landmarks, OfTriplets());
    EXPECT_LT(shapetest::MapErrors(result.Maps.AToB, mesh, wanted).mean(), 0.05) << third;
    // Landmarks go to their partners in every candidate.
    for (Eigen::Index i = 0; i < result.TriplesOfA.size(); ++i)
    {
      const int point = result.TriplesOfA.reshaped()(i);
      EXPECT_TRUE(point != landmarks[0][0] || result.TriplesOfB.reshaped()(i) == landmarks[0][1]);
    }
  }
}

TEST(BlendedIntrinsic, TheGroupWithTheGreatestConfidenceWins)
{
  // Maps of four points: three agree on one image with little trust, two on another one with much.
  const auto image = [](double position, double trust)
  {
    return shape::ConformalImages{ Eigen::MatrixXd::Constant(4, 2, position),
      Eigen::VectorXd::Constant(4, trust) };
  };
  std::vector<shape::ConformalImages> images = { image(0, 0.5), image(0, 0.5), image(0, 0.5),
    image(5, 0.9), image(5, 0.9) };
  const Eigen::MatrixXd consistency = shape::ComputeConsistency(images, 0.1);
  Eigen::MatrixXd blocks = Eigen::MatrixXd::Zero(5, 5);
  blocks.topLeftCorner(3, 3).setConstant(0.25);
  blocks.bottomRightCorner(2, 2).setConstant(0.81);
  EXPECT_LT((consistency - blocks).cwiseAbs().maxCoeff(), 1e-12);
  // Total confidences: 3 * 0.5 and 2 * 0.9.
  Eigen::VectorXd weights = shape::FindBestGroup(images, consistency, 0.1, 0.2);
  EXPECT_LT((weights - Eigen::VectorXd{ { 0, 0, 0, 1, 1 } }.normalized()).norm(), 1e-12);
  // Four maps with little trust have the smaller eigenvalue, but the greater confidence: 4 * 0.5.
  images.push_back(image(0, 0.5));
  const Eigen::MatrixXd larger = shape::ComputeConsistency(images, 0.1);
  const Eigen::VectorXd first{ { 1, 1, 1, 0, 0, 1 } }, second{ { 0, 0, 0, 1, 1, 0 } };
  weights = shape::FindBestGroup(images, larger, 0.1, 0.5);
  EXPECT_LT((weights - first.normalized()).norm(), 1e-12);
  weights = shape::FindBestGroup(images, larger, 0.1, 1.0);
  EXPECT_LT((weights - second.normalized()).norm(), 1e-12);
}

TEST(BlendedIntrinsic, TheConfidenceFallsWithTheSpreadOfTheImages)
{
  shape::ImageBlend blend(1, 1);
  blend.Add({ Eigen::MatrixXd::Constant(1, 1, -0.1), Eigen::VectorXd::Constant(1, 0.5) }, 2.0);
  blend.Add({ Eigen::MatrixXd::Constant(1, 1, 0.1), Eigen::VectorXd::Constant(1, 1.0) }, 1.0);
  // Both have the blending weight 1: mean 0, standard deviation 0.1, mean trust 0.75.
  EXPECT_NEAR(blend.Means()(0, 0), 0.0, 1e-15);
  EXPECT_NEAR(blend.Confidences(0.1)(0), 0.75 * std::exp(-1.0), 1e-12);
}

TEST(BlendedIntrinsic, SimilarTriplesKeepDistancesAndGivenPairs)
{
  // Points on a line.
  const Eigen::VectorXd places{ { 0.0, 1.0, 3.0, 7.0 } };
  const Eigen::MatrixXd between =
    (places.replicate(1, 4) - places.transpose().replicate(4, 1)).cwiseAbs();
  const auto same = shape::FindSimilarTriples(between, between, 4, 1e-6);
  ASSERT_EQ(same.size(), 4U); // each triple only with itself, since all distances differ
  for (const shape::TriplePair& pair : same)
  {
    EXPECT_EQ(pair.OfA, pair.OfB);
  }
  EXPECT_EQ(shape::FindSimilarTriples(between, between, 4, 1.0).size(), 4U * 24U); // all
  EXPECT_EQ(shape::FindSimilarTriples(between, between, 3, 1.0).size(), 6U);       // of the first
  // Point 0 goes to 0 only: 3 triples with it and 3 * 2 partners each, one without it and 6.
  EXPECT_EQ(shape::FindSimilarTriples(between, between, 4, 1.0, 1).size(), 3U * 6U + 6U);
}

TEST(BlendedIntrinsic, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 24, 12);
  EXPECT_REFUSED(shape::ComputeBlendedIntrinsicMap(sphere, torus, {}), "surface B has genus 1");
  EXPECT_REFUSED(shape::ComputeBlendedIntrinsicMap(torus, sphere, {}), "surface A has genus 1");
  EXPECT_REFUSED(
    shape::ComputeBlendedIntrinsicMap(sphere, sphere, { { 0, 0 }, { 9, 9 } }), "2 landmarks");
  EXPECT_REFUSED(
    shape::ComputeBlendedIntrinsicMap(sphere, sphere, { { 0, 0 }, { 0, 9 }, { 0, 7 } }),
    "no three");
  EXPECT_REFUSED(
    shape::ComputeBlendedIntrinsicMap(sphere, sphere, { { 0, 0 }, { 9, 9 }, { 9999, 7 } }), "9999");
  EXPECT_REFUSED(
    shape::ComputeBlendedIntrinsicMap(shapetest::Twice(sphere), sphere, {}), "2 components");
  shape::BlendedIntrinsicOptions options = OfTriplets();
  options.TripletTolerance = 1e-9;
  EXPECT_REFUSED(
    shape::ComputeBlendedIntrinsicMap(sphere, ThreeLobes(), {}, options), "raise TripletTolerance");
  options.GroupShare = 0.0;
  EXPECT_REFUSED(shape::ComputeBlendedIntrinsicMap(sphere, sphere, {}, options), "GroupShare");
}
