// Facts checked: on a plane a loop lands as a similarity says, with the axes turned by the shortest
// way and then about the normal; on a sphere each point is as far along the surface and in the
// direction as in the base's plane; the band is what lies between the loop and the ring; on the
// surface that it is from a base returns to where it was; what was landed before does not count;
// where the exponential map folds another layout takes the loop; what does not fit is refused with
// the largest scale that does.

#include "CutPaste/PasteTarget.h"

#include "Base/Errors.h"
#include "CutPaste/FootprintLayout.h"
#include "Mesh/BoundaryLoops.h"
#include "Support/CurveShapes.h"
#include "Support/DeformShapes.h"
#include "Support/HoleShapes.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace
{

using Eigen::MatrixXd;
using Eigen::RowVector3d;
using Eigen::Vector3d;

/// A circle around the seed, in a plane with this normal and x axis.
shape::FeatureFootprint CircleBase(double radius, const RowVector3d& normal = RowVector3d(0, 0, 1),
  const RowVector3d& xAxis = RowVector3d(1, 0, 0))
{
  constexpr int corners = 30;
  shape::FeatureFootprint base;
  base.Loop.resize(corners);
  std::iota(base.Loop.begin(), base.Loop.end(), 0);
  base.LoopPositions.resize(corners, 2);
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * i / corners;
    base.LoopPositions.row(i) << radius * std::cos(angle), radius * std::sin(angle);
  }
  base.Normals = normal.replicate(corners, 1);
  base.Normal = normal;
  base.XAxis = xAxis;
  return base;
}

/// The directions of a base's places in space when its plane is turned to a normal by the shortest
/// way and then about that by an angle in degrees (n x 3, as long as the places).
MatrixXd Directions(const shape::FeatureFootprint& base, const RowVector3d& normal, double rotation)
{
  const Vector3d to = normal.transpose();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(rotation * M_PI / 180.0, to).toRotationMatrix() *
    Eigen::Quaterniond::FromTwoVectors(base.Normal.transpose(), to).toRotationMatrix();
  MatrixXd axes(2, 3);
  axes << base.XAxis, base.Normal.cross(base.XAxis);
  return base.LoopPositions * axes * turn.transpose();
}

shape::PastePlacement At(const RowVector3d& seed, double rotation = 0.0, double scale = 1.0)
{
  shape::PastePlacement placement;
  placement.Seed = seed;
  placement.Rotation = rotation;
  placement.Scale = scale;
  return placement;
}

/// That the band's triangles cover what is between the loop and the ring, facing upwards.
void ExpectBandBetween(const shape::LoopOnTarget& landing)
{
  const Eigen::Index loop = landing.Cover.Loop.rows(), ring = landing.Cover.RingImage.rows();
  shape::Mesh band{ MatrixXd::Zero(
                      loop + ring + static_cast<Eigen::Index>(landing.Join.Midpoints.size()), 3),
    landing.Join.Triangles };
  band.Points.topLeftCorner(loop, 2) = landing.Cover.Loop;
  band.Points.block(loop, 0, ring, 2) = landing.Cover.RingImage;
  Eigen::Index row = loop + ring;
  for (const auto& [a, b] : landing.Join.Midpoints)
  {
    band.Points.row(row++) = 0.5 * (band.Points.row(a) + band.Points.row(b));
  }
  const Eigen::VectorXd areas = 0.5 * shape::ComputeAreaVectors(band).col(2);
  EXPECT_GT(areas.minCoeff(), 0.0);
  EXPECT_NEAR(areas.sum(),
    shapetest::PolygonArea(landing.Cover.RingImage) - shapetest::PolygonArea(landing.Cover.Loop),
    1e-12);
}

TEST(PasteTarget, OnAPlaneALoopLandsAsASimilaritySays)
{
  const Eigen::Matrix3d turn = shapetest::SomeRotation();
  shape::Mesh plane = shapetest::FlatSquare(40, 0.3);
  const RowVector3d seed(0.12, -0.21, 0.0), normal = turn.col(2).transpose(), shift(3, -7, 2);
  plane.Points = shapetest::Moved(plane.Points, turn, 1.0, shift);
  shape::PasteTarget target(plane);
  EXPECT_EQ(target.EulerNumber(), 1);
  const RowVector3d there = seed * turn.transpose() + shift;
  for (const shape::FeatureFootprint& base :
    { CircleBase(0.3), CircleBase(0.3, { 0, 1, 0 }, { 0, 0, 1 }),
      CircleBase(0.3, normal, RowVector3d(turn.col(1).transpose())) })
  {
    for (const double rotation : { 0.0, 35.0, -200.0 })
    {
      // The seed above the plane: it is taken there.
      const shape::LoopOnTarget landing =
        target.Land(base, At(there + 0.4 * normal, rotation, 1.7));
      const MatrixXd wanted = (1.7 * Directions(base, normal, rotation)).rowwise() + there;
      EXPECT_LT((landing.Positions - wanted).rowwise().norm().maxCoeff(), 1e-12);
      EXPECT_LT((landing.Normals.rowwise() - normal).rowwise().norm().maxCoeff(), 1e-12);
      EXPECT_LT((landing.Seed.Origin - there).norm(), 1e-12);
      EXPECT_EQ(landing.Layout, shape::TargetLayout::ExponentialMap);
      ExpectBandBetween(landing);
    }
  }
  // Upside down there is no shortest way: any half turn will do.
  const shape::FeatureFootprint turned =
    CircleBase(0.3, -normal, RowVector3d(turn.col(0).transpose()));
  const shape::LoopOnTarget landing = target.Land(turned, At(there));
  EXPECT_LT(
    ((landing.Positions.rowwise() - there).rowwise().norm().array() - 0.3).abs().maxCoeff(), 1e-12);
}

TEST(PasteTarget, OnASphereDistancesAndDirectionsFromTheSeedAreKept)
{
  shape::PasteTarget target(shapetest::Icosphere(5));
  EXPECT_EQ(target.EulerNumber(), 2);
  const shape::FeatureFootprint base = CircleBase(0.5, { 1, 0, 0 }, { 0, 1, 0 });
  for (const double rotation : { 0.0, 70.0 })
  {
    const RowVector3d seed = RowVector3d(0.5, -0.6, 0.4).normalized();
    const shape::LoopOnTarget landing = target.Land(base, At(3.0 * seed, rotation, 1.5));
    const MatrixXd directions = Directions(base, seed, rotation) / 0.5;
    const MatrixXd wanted = (std::sin(0.75) * directions).rowwise() + std::cos(0.75) * seed;
    EXPECT_LT((landing.Positions - wanted).rowwise().norm().maxCoeff(), 0.01);
    EXPECT_LT((landing.Normals - wanted).rowwise().norm().maxCoeff(), 0.02);
    EXPECT_LT((landing.Normals.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-14);
    ExpectBandBetween(landing);
  }
}

/// A base cut from a surface: the triangles whose centroids are less than `radius` from the seed.
struct CutBase
{
  CutBase(const shape::Mesh& surface, const RowVector3d& seed, double radius)
  {
    const auto isNear = [&](const RowVector3d& position)
    { return (position - seed).norm() < radius; };
    const shape::Mesh part =
      shapetest::Without(surface, [&](const RowVector3d& position) { return !isNear(position); });
    this->On = shape::FindManifoldBoundaryLoops(part).front();
    std::vector<int> loop(this->On.size());
    std::iota(loop.begin(), loop.end(), 0);
    this->Base = shape::BuildFootprintsOnSurface(surface, { { seed, loop, this->On } }).front();
    for (int t = 0; t < static_cast<int>(surface.Triangles.rows()); ++t)
    {
      if (isNear(shape::GetCorners(surface, t).colwise().mean()))
      {
        this->Within.push_back(t);
      }
    }
  }

  std::vector<int> On, Within;
  shape::FeatureFootprint Base;
};

TEST(PasteTarget, ABaseReturnsToWhereItWas)
{
  const shape::Mesh cap = shapetest::Cap(24);
  const RowVector3d seed = cap.Points.row(100);
  const CutBase cut(cap, seed, 0.4);
  EXPECT_TRUE(cut.Base.ReturnsInPlace);
  shape::PasteTarget target(cap);
  target.Land(CircleBase(0.2), At(cap.Points.row(500))); // elsewhere before
  const shape::LoopOnTarget landing = target.Land(cut.Base, At(seed));
  EXPECT_LT((landing.Positions - cap.Points(cut.On, Eigen::all)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(landing.Join.Triangles.rows(), 0);
  std::vector<int> covered = landing.Cover.Triangles;
  std::sort(covered.begin(), covered.end());
  EXPECT_EQ(covered, cut.Within);
  const shape::LoopOnTarget first = shape::PasteTarget(cap).Land(cut.Base, At(seed));
  EXPECT_EQ(first.Positions, landing.Positions);
  EXPECT_EQ(first.Normals, landing.Normals);
}

TEST(PasteTarget, WhereTheMapFoldsAnotherLayoutTakesTheLoop)
{
  // A finger on a plane, and a loop around it from a seed beside it.
  shape::Mesh finger = shapetest::FlatSquare(40, 0.2);
  for (auto point : finger.Points.rowwise())
  {
    point(2) = 0.6 * std::exp(-point.squaredNorm() / 0.02);
  }
  shape::PasteTarget target(finger);
  const shape::FeatureFootprint base = CircleBase(0.7);
  const shape::LoopOnTarget landing = target.Land(base, At({ -0.2, 0.0, 0.0 }));
  EXPECT_EQ(landing.Layout, shape::TargetLayout::Conformal);
  ExpectBandBetween(landing);
  EXPECT_TRUE(shape::IsSimplePolygon(landing.Positions.leftCols(2))); // seen from above
  EXPECT_GT(shapetest::PolygonArea(landing.Positions.leftCols(2)), 0.5);
  const std::set<int> covered(landing.Cover.Triangles.begin(), landing.Cover.Triangles.end());
  for (int t = 0; t < static_cast<int>(finger.Triangles.rows()); ++t)
  {
    const bool isOfFinger = shape::GetCorners(finger, t).col(2).maxCoeff() > 0.01;
    EXPECT_TRUE(!isOfFinger || covered.count(t) > 0);
  }
  EXPECT_EQ(target.Land(base, At({ -0.2, 0.0, 0.0 }), false).Positions, landing.Positions);
}

TEST(PasteTarget, WhatDoesNotFitIsRefusedWithTheLargestScaleThatDoes)
{
  // The circle's left end is 0.5 from the square's border.
  shape::PasteTarget target(shapetest::FlatSquare(40, 0.2));
  const shape::FeatureFootprint base = CircleBase(0.4);
  const std::string words = shapetest::Refusal(
    [&] {
      target.Land(base, At({ -0.5, 0.1, 0.0 }, 0.0, 2.0));
    });
  const auto at = words.find("Scale to ");
  ASSERT_NE(at, std::string::npos) << words;
  EXPECT_NE(words.find("beyond the boundary"), std::string::npos) << words;
  const double scale = std::stod(words.substr(at + 9));
  EXPECT_NEAR(scale, 1.25, 0.03);
  EXPECT_NO_THROW(target.Land(base, At({ -0.5, 0.1, 0.0 }, 0.0, scale)));
  EXPECT_THROW(target.Land(base, At({ -0.5, 0.1, 0.0 }, 0.0, 1.26), false), shape::InvalidInput);

  // Around a tube's handle no scale that wraps it will do.
  shape::PasteTarget torus(shapetest::Torus(3.0, 0.5, 60, 20));
  EXPECT_THROW(torus.Land(CircleBase(2.5), At({ 3.5, 0.0, 0.0 })), shape::InvalidInput);
  EXPECT_NO_THROW(torus.Land(CircleBase(0.5), At({ 3.5, 0.0, 0.0 })));
}

TEST(PasteTarget, RefusesWrongTargetsAndPlacements)
{
  shape::Mesh disk = shapetest::FlatDisk(8);
  shape::PasteTarget target(disk);
  const shape::FeatureFootprint base = CircleBase(0.3);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const RowVector3d seed(0, 0, 0);
  EXPECT_NO_THROW(target.Land(base, At(seed)));
  for (const double wrong : { 0.0, -1.0, nan, infinity })
  {
    EXPECT_REFUSED(target.Land(base, At(seed, 0.0, wrong)), "Scale");
  }
  EXPECT_REFUSED(target.Land(base, At(seed, nan)), "Rotation");
  EXPECT_REFUSED(target.Land(base, At({ 0, nan, 0 })), "Seed");
  EXPECT_THROW(target.Land(base, At(seed), true, shape::Progress([](double) { return false; })),
    shape::Aborted);
  disk.Triangles.row(5).reverseInPlace();
  EXPECT_THROW(shape::PasteTarget{ disk }, shape::InvalidInput);
  disk.Triangles.row(5) = disk.Triangles.row(4);
  EXPECT_THROW(shape::PasteTarget{ disk }, shape::InvalidInput);
}

} // namespace
