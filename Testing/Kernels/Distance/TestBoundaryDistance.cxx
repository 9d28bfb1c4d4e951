#include "Base/Errors.h"
#include "Distance/BoundaryDistance.h"
#include "Solids/Nesting.h"
#include "Support/RandomPoints.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using shapetest::Joined;
using shapetest::Reversed;

namespace
{

shape::Mesh Sphere(double radius, const Eigen::RowVector3d& centre)
{
  return shapetest::Sphere(3, radius, centre);
}

/// The unit cube with its lowest corner at `low`.
shape::Mesh Cube(const Eigen::RowVector3d& low)
{
  return shapetest::Box(low, low.array() + 1.0);
}

Eigen::MatrixXd RandomPoints(int count, double halfEdge)
{
  return shapetest::RandomPointsInCube(count, halfEdge, 11);
}

const Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();

} // namespace

TEST(OrientByNesting, MakesTheVolumeOfTheSolidWhicheverWayItsSurfacesFace)
{
  // A ball with a void in which a ball floats, and a ball beside: each in both orientations.
  const std::vector<shape::Mesh> parts = { Sphere(0.4, Origin), Sphere(1.0, Origin),
    Sphere(0.7, Origin), Sphere(0.3, { 2, 0, 0 }) };
  const double unit = shape::ComputeEnclosedVolume(Sphere(1.0, Origin));
  const double solid = unit * (1.0 - std::pow(0.7, 3) + std::pow(0.4, 3) + std::pow(0.3, 3));
  for (int turned = 0; turned < 16; ++turned)
  {
    std::vector<shape::Mesh> some = parts;
    for (int i = 0; i < 4; ++i)
    {
      some[i] = turned >> i & 1 ? Reversed(parts[i]) : parts[i];
    }
    const shape::Mesh oriented = shape::OrientByNesting(Joined(some), "it");
    EXPECT_NEAR(shape::ComputeEnclosedVolume(oriented), solid, 1e-12) << turned;
    const Eigen::MatrixXi expected =
      Joined({ parts[0], parts[1], Reversed(parts[2]), parts[3] }).Triangles;
    for (Eigen::Index t = 0; t < expected.rows(); ++t)
    {
      EXPECT_TRUE((oriented.Triangles.row(t).array() == expected.row(t).array()).all());
    }
  }
}

TEST(OrientByNesting, ASurfaceThatFacesTheRightWayIsItself)
{
  const shape::Surface ball = Sphere(1.0, Origin);
  EXPECT_EQ(&shape::OrientByNesting(ball, "it").Points(), &ball.Points());
  const shape::Surface inverted = Reversed(ball);
  EXPECT_EQ(shape::OrientByNesting(inverted, "it").Triangles().rows(), ball.Triangles().rows());
  EXPECT_LT(shape::ComputeEnclosedVolume(inverted), 0.0);
  EXPECT_GT(shape::ComputeEnclosedVolume(shape::OrientByNesting(inverted, "it")), 0.0);
}

TEST(OrientByNesting, AComponentInTheHoleOfATorusIsNotInside)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.3, 48, 24), ball = Sphere(0.2, Origin);
  const shape::Mesh oriented = shape::OrientByNesting(Joined({ Reversed(ball), torus }), "it");
  EXPECT_NEAR(shape::ComputeEnclosedVolume(oriented),
    shape::ComputeEnclosedVolume(torus) + shape::ComputeEnclosedVolume(ball), 1e-12);
  const shape::Mesh inTube = Sphere(0.2, { 1, 0, 0 });
  EXPECT_NEAR(shape::ComputeEnclosedVolume(shape::OrientByNesting(Joined({ inTube, torus }), "it")),
    shape::ComputeEnclosedVolume(torus) - shape::ComputeEnclosedVolume(inTube), 1e-12);
}

TEST(OrientByNesting, RefusesComponentsThatTouchOrCross)
{
  const shape::Mesh cube = Cube(Origin);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(cube), 1.0, 1e-15);
  // Across, sharing a face, an edge, a corner; the middle of a face on a corner.
  for (const Eigen::RowVector3d& low : { Eigen::RowVector3d(0.5, 0.5, 0.5),
         Eigen::RowVector3d(1, 0, 0), Eigen::RowVector3d(1, 1, 0), Eigen::RowVector3d(1, 1, 1),
         Eigen::RowVector3d(0.5, 0.5, 1), Eigen::RowVector3d(0.1, 0.2, 0.3) })
  {
    EXPECT_THROW(shape::OrientByNesting(Joined({ cube, Cube(low) }), "it"), shape::InvalidInput)
      << low;
  }
  EXPECT_NO_THROW(shape::OrientByNesting(Joined({ cube, Cube({ 1.001, 0, 0 }) }), "it"));
  EXPECT_REFUSED(
    shape::BoundaryDistance(Joined({ Sphere(1.0, Origin), Sphere(1.0, { 0.5, 0, 0 }) })),
    "touch or cross (the components of points 0 and 642", "turn Signed off");
}

TEST(BoundaryDistance, OfAShellIsNegativeInTheShellAlone)
{
  const Eigen::MatrixXd points = RandomPoints(2000, 1.5);
  for (const shape::Mesh& inner : { Sphere(0.5, Origin), Reversed(Sphere(0.5, Origin)) })
  {
    const shape::BoundaryDistance distance(Joined({ Reversed(Sphere(1.0, Origin)), inner }));
    const Eigen::VectorXd values = distance.Evaluate(points);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      // The facets lie up to 0.006 below the sphere.
      const double radius = points.row(i).norm();
      EXPECT_NEAR(values(i), std::max(radius - 1.0, 0.5 - radius), 7e-3);
    }
  }
}

TEST(BoundaryDistance, OfACubeIsExact)
{
  const Eigen::MatrixXd points = RandomPoints(3000, 2.0);
  const shape::BoundaryDistance distance(Cube({ -0.5, -0.5, -0.5 }));
  const Eigen::VectorXd values = distance.Evaluate(points);
  const Eigen::VectorXd unsignedValues =
    shape::BoundaryDistance(Cube({ -0.5, -0.5, -0.5 }), { false }).Evaluate(points);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::Array3d beyond = points.row(i).transpose().array().abs() - 0.5;
    const double exact =
      beyond.max(0.0).matrix().norm() + std::min(0.0, static_cast<double>(beyond.maxCoeff()));
    EXPECT_NEAR(values(i), exact, 1e-14);
    EXPECT_NEAR(unsignedValues(i), std::abs(exact), 1e-14);
  }
}

TEST(BoundaryDistance, AnOpenSurfaceHasNoInside)
{
  shape::Mesh open = shapetest::WithoutLast(Sphere(1.0, Origin));
  EXPECT_REFUSED(shape::BoundaryDistance{ open }, "1 open loop", "turn Signed off");
  EXPECT_NEAR(
    shape::BoundaryDistance(open, { false }).Evaluate(Eigen::MatrixXd::Zero(1, 3))(0), 1.0, 7e-3);
  open.Triangles.resize(0, 3);
  EXPECT_REFUSED(shape::BoundaryDistance{ open }, "no polygons");
  shape::Mesh spoiled = Sphere(1.0, Origin);
  spoiled.Points(5, 1) = std::numeric_limits<double>::quiet_NaN();
  const std::string refusal =
    shapetest::Refusal([&] { shape::BoundaryDistance distance(spoiled); });
  EXPECT_EQ(refusal.find("Signed"), std::string::npos);
  EXPECT_NE(refusal.find("first at point 5"), std::string::npos) << refusal;
  EXPECT_THROW(
    shape::BoundaryDistance(Sphere(1.0, Origin)).Evaluate(spoiled.Points), shape::InvalidInput);
}
