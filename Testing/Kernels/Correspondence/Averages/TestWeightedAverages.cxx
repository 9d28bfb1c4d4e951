#include "Base/Errors.h"
#include "Correspondence/Averages/WeightedAverages.h"
#include "Geodesics/FarthestPoints.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using shapetest::PositionsOn;

namespace
{

shape::Landmarks Same(const std::vector<int>& points)
{
  shape::Landmarks landmarks;
  for (const int point : points)
  {
    landmarks.push_back({ point, point });
  }
  return landmarks;
}

/// A point inside each triangle where a walk may begin.
shape::SurfacePoint MiddleOf(int triangle)
{
  return { triangle, Eigen::RowVector3d::Constant(1.0 / 3.0) };
}

} // namespace

TEST(PhongProjection, IsTheOrthogonalProjectionOntoAPlane)
{
  shape::Mesh disk = shapetest::FlatDisk(8);
  disk.Points = disk.Points * shapetest::Rotation(0.7, { 1.0, 2.0, 0.3 }).transpose();
  const shape::PhongProjection projection(disk, disk.Points);
  const Eigen::RowVector3d normal =
    Eigen::RowVector3d::UnitZ() * shapetest::Rotation(0.7, { 1.0, 2.0, 0.3 }).transpose();
  for (int t = 0; t < static_cast<int>(disk.Triangles.rows()); t += 7)
  {
    const Eigen::RowVector3d foot = shape::GetPosition(disk, { t, { 0.2, 0.5, 0.3 } });
    const shape::SurfacePoint found = projection.Find(foot + 0.8 * normal, MiddleOf(0));
    EXPECT_LT((shape::GetPosition(disk, found) - foot).norm(), 1e-9);
  }
}

TEST(PhongProjection, OfASphereLeadsToItsCentreTheMoreTheFinerTheMesh)
{
  // The direction of the position, from inside and from outside.
  double before = 1.0;
  for (const int level : { 2, 3, 4 })
  {
    const shape::Mesh sphere = shapetest::Icosphere(level);
    const shape::PhongProjection projection(sphere, sphere.Points);
    double worst = 0.0;
    for (int i = 0; i < 200; ++i)
    {
      const Eigen::RowVector3d direction =
        Eigen::RowVector3d(std::sin(1.0 + i), std::cos(2.0 * i), std::sin(3.0 * i + 0.4))
          .normalized();
      const shape::SurfacePoint found = projection.Find((0.6 + 0.004 * i) * direction, MiddleOf(i));
      worst = std::max(worst, (shape::GetPosition(sphere, found).normalized() - direction).norm());
    }
    EXPECT_LT(worst, 0.7 * before);
    before = worst;
  }
  EXPECT_LT(before, 0.01);
}

TEST(PhongProjection, IsContinuousAcrossEdges)
{
  // A small step of a position near the surface moves its projection by a small step, also where
  // the closest point would stay on an edge or leap across it.
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const shape::PhongProjection projection(sphere, sphere.Points);
  shape::SurfacePoint at = MiddleOf(0);
  Eigen::RowVector3d before = Eigen::RowVector3d::Zero();
  constexpr int steps = 2000;
  double longest = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double angle = 2.0 * M_PI * i / steps;
    at = projection.Find(
      0.8 * Eigen::RowVector3d(std::cos(angle), std::sin(angle), 0.3 * std::cos(angle)), at);
    const Eigen::RowVector3d place = shape::GetPosition(sphere, at);
    longest = i > 0 ? std::max(longest, (place - before).norm()) : longest;
    before = place;
  }
  EXPECT_LT(longest, 3.0 * 2.0 * M_PI / steps);
}

TEST(WeightedAverages, WeightsReproduceTheirPoint)
{
  const shape::Surface pebble = shapetest::Pebble(shapetest::Icosphere(3));
  const std::vector<int> landmarks = shape::SampleFarthestPoints(pebble, 8);
  const shape::LandmarkAverages averages(pebble, landmarks, 0.2 * shape::EmbedBySmacof(pebble));
  for (int vertex = 0; vertex < 642; vertex += 5)
  {
    const Eigen::RowVectorXd weights = averages.WeightsAt(vertex);
    EXPECT_NEAR(weights.sum(), 1.0, 1e-12);
    // From the point itself, the search ends where it begins.
    const auto at =
      shape::MakeSurfacePointsAtVertices(Eigen::VectorXi::Constant(1, vertex), pebble);
    const shape::SurfacePoint found =
      averages.Average(weights, { at.Triangles(0), at.Barycentrics.row(0) });
    EXPECT_LT((shape::GetPosition(pebble, found) - pebble.Points().row(vertex)).norm(), 1e-6);
  }
  for (std::size_t i = 0; i < landmarks.size(); ++i)
  {
    EXPECT_EQ(averages.WeightsAt(landmarks[i]),
      Eigen::RowVectorXd::Unit(
        static_cast<Eigen::Index>(landmarks.size()), static_cast<Eigen::Index>(i)));
  }
}

TEST(WeightedAverages, ASurfaceAndItsRotatedCopyGiveTheIdentity)
{
  const shape::Surface a = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d turn = shapetest::Rotation(2.0, { 0.3, -0.5, 0.8 });
  const shape::Surface b = a.WithPoints(a.Points() * turn.transpose());
  const auto maps = shape::MapByWeightedAverages(a, b, Same(shape::SampleFarthestPoints(a, 10)));
  EXPECT_LT((PositionsOn(maps.AToB, b) - b.Points()).rowwise().norm().maxCoeff(), 1e-6);
  EXPECT_LT((PositionsOn(maps.BToA, a) - a.Points()).rowwise().norm().maxCoeff(), 1e-6);
}

TEST(WeightedAverages, LandmarksAreExactAndOtherMeshesNear)
{
  // The embedding is not that of a limit, so errors do not fall with the edges' length.
  const std::vector<int> points = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 };
  const shape::Mesh a = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity()),
                    b = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  const auto maps = shape::MapByWeightedAverages(a, b, Same(points));
  const Eigen::VectorXd errors =
    shapetest::MapErrors(maps.AToB, b, b.Points.topRows(a.Points.rows()));
  EXPECT_EQ(errors.head(12).maxCoeff(), 0.0);
  EXPECT_LT(errors.mean(), 0.05);
}

TEST(WeightedAverages, AFlatDiskAndItsAffineImageGiveTheAffineMap)
{
  // In the plane, which is its own embedding, weights are those of an affine combination.
  const shape::Surface a = shapetest::FlatDisk(12);
  Eigen::MatrixXd moved = a.Points();
  moved.col(0) = 1.3 * a.Points().col(0) + 0.3 * a.Points().col(1);
  const shape::Surface b = a.WithPoints(moved);
  const std::vector<int> landmarks = shape::SampleFarthestPoints(a, 6);
  const shape::LandmarkAverages ofA(a, landmarks, a.Points().leftCols(2)),
    ofB(b, landmarks, moved.leftCols(2));
  for (int vertex = 0; vertex < static_cast<int>(moved.rows()); ++vertex)
  {
    const Eigen::RowVectorXd weights = ofA.WeightsAt(vertex);
    EXPECT_LT((weights * moved(landmarks, Eigen::all) - moved.row(vertex)).norm(), 1e-9);
    const shape::SurfacePoint found = ofB.Average(weights, MiddleOf(0));
    EXPECT_LT((shape::GetPosition(b, found) - moved.row(vertex)).norm(), 1e-9);
  }
}

TEST(WeightedAverages, TooFewLandmarksAreRefused)
{
  const shape::Mesh sphere = shapetest::Icosphere(1);
  EXPECT_REFUSED(
    shape::MapByWeightedAverages(sphere, sphere, Same({ 0, 5 })), "give three or more");
}
