#include "Base/Errors.h"
#include "Correspondence/Conformal/SphereCommonDomain.h"
#include "Parameterize/SphericalTriangles.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

const std::vector<int> Landmarks = { 0, 3, 4, 7, 8, 10, 25 };

} // namespace

TEST(SphereCommonDomain, ASurfaceAndItsRotatedCopyGiveTheIdentity)
{
  const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(3));
  shape::Mesh b = a;
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.0, Eigen::Vector3d(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  b.Points = a.Points * turn.transpose();
  shape::SphereCommonDomainOptions options;
  options.RelaxationSweeps = 0; // which lowers another energy than the sphere maps do
  const auto map = shape::MapThroughSphere(a, Landmarks, b, Landmarks, options);
  EXPECT_LT((shapetest::PositionsOn(map.AToB, b) - b.Points).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LT((shapetest::PositionsOn(map.BToA, a) - a.Points).cwiseAbs().maxCoeff(), 1e-4);
}

TEST(SphereCommonDomain, MeetsManyLandmarksWithoutAFlip)
{
  const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(3));
  shape::Mesh b = shapetest::Icosphere(4);
  b.Points.col(2) *= 1.8;
  // The same corners of the icosahedron, and others near them, so that all have to move.
  const std::vector<int> onB = { 0, 3, 4, 7, 8, 10, 60 };
  const auto map = shape::MapThroughSphere(a, Landmarks, b, onB);
  EXPECT_TRUE(shape::FindFlippedTriangles(a.Triangles, map.SphereA).empty());
  EXPECT_EQ(shape::ComputeCoveringDegree(a.Triangles, map.SphereA), 1);
  for (std::size_t i = 0; i < onB.size(); ++i)
  {
    Eigen::Index corner = 0;
    EXPECT_EQ(map.AToB.Barycentrics.row(Landmarks[i]).maxCoeff(&corner), 1.0);
    EXPECT_EQ(b.Triangles(map.AToB.Triangles(Landmarks[i]), corner), onB[i]);
    EXPECT_EQ(map.BToA.Barycentrics.row(onB[i]).maxCoeff(&corner), 1.0);
    EXPECT_EQ(a.Triangles(map.BToA.Triangles(onB[i]), corner), Landmarks[i]);
  }
  // There and back on the sphere.
  const Eigen::MatrixXd onSphereB =
    shape::PullBack(map.AToB, b.Triangles, map.SphereB).rowwise().normalized();
  EXPECT_LT((onSphereB - map.SphereA).cwiseAbs().maxCoeff(), 1e-10);
  const auto back = shape::LocateDirections({ map.SphereA, a.Triangles }, onSphereB);
  EXPECT_LT((shapetest::PositionsOn(back, a) - a.Points).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_NEAR(shape::ComputeWindingNumber(shapetest::PositionsOn(map.AToB, b), a.Triangles,
                Eigen::RowVector3d(0.01, 0.02, 0.03)),
    1.0, 1e-9);
}

TEST(SphereCommonDomain, DirectionsAreFoundWhereTheyPass)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const Eigen::MatrixXd directions = 7.0 * shape::SampleRandomly(sphere, 500, 3);
  const shape::SurfacePoints map = shape::LocateDirections(sphere, directions);
  EXPECT_LT((7.0 * shapetest::PositionsOn(map, sphere) - directions).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SphereCommonDomain, WhatCannotBeMetIsRefusedWithTheFact)
{
  const shape::Mesh a = shapetest::Pebble(shapetest::Icosphere(2));
  EXPECT_REFUSED(
    shape::MapThroughSphere(a, { 0, 1 }, a, { 0 }), "surface A has 2 landmarks, surface B 1");
  EXPECT_REFUSED(shape::MapThroughSphere(a, { 0, 1, 0 }, a, { 0, 1, 2 }),
    "two landmarks of surface A are the same");
  EXPECT_REFUSED(shape::MapThroughSphere(a, { 0, 1 }, a, { 0, 999 }), "surface B is point 999");
  shape::Mesh inside = a;
  inside.Triangles = inside.Triangles.rowwise().reverse().eval();
  EXPECT_THROW(shape::MapThroughSphere(a, { 0 }, inside, { 0 }), shape::InvalidInput);
}
