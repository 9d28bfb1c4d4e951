#include "Base/Errors.h"
#include "Distance/BoundaryDistance.h"
#include "Solids/Nesting.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

shape::Mesh Turned(shape::Mesh mesh)
{
  mesh.Triangles.col(1).swap(mesh.Triangles.col(2));
  return mesh;
}

shape::Mesh Sphere(double radius, const Eigen::RowVector3d& centre)
{
  shape::Mesh sphere = shapetest::Icosphere(3);
  sphere.Points = (radius * sphere.Points).rowwise() + centre;
  return sphere;
}

shape::Mesh Joined(const std::vector<shape::Mesh>& parts)
{
  shape::Mesh all;
  for (const shape::Mesh& part : parts)
  {
    const Eigen::Index n = all.Points.rows(), m = all.Triangles.rows();
    all.Points.conservativeResize(n + part.Points.rows(), 3);
    all.Triangles.conservativeResize(m + part.Triangles.rows(), 3);
    all.Points.bottomRows(part.Points.rows()) = part.Points;
    all.Triangles.bottomRows(part.Triangles.rows()) = part.Triangles.array() + static_cast<int>(n);
  }
  return all;
}

/// The cube with corners at `low` and `low` + 1, two triangles a side.
shape::Mesh Cube(const Eigen::RowVector3d& low)
{
  shape::Mesh cube{ Eigen::MatrixXd(8, 3), Eigen::MatrixXi(12, 3) };
  for (int i = 0; i < 8; ++i)
  {
    cube.Points.row(i) = low + Eigen::RowVector3d(i & 1, i >> 1 & 1, i >> 2);
  }
  cube.Triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6,
    0, 6, 2, 1, 3, 7, 1, 7, 5;
  return cube;
}

Eigen::MatrixXd RandomPoints(int count, double halfSide)
{
  std::mt19937_64 generator(11);
  Eigen::MatrixXd points(count, 3);
  for (double& value : points.reshaped())
  {
    value = halfSide * (2.0 * static_cast<double>(generator() >> 11) * 0x1p-53 - 1.0);
  }
  return points;
}

std::string ErrorOf(const shape::Mesh& surface)
{
  try
  {
    shape::BoundaryDistance distance(surface);
  }
  catch (const shape::InvalidInput& error)
  {
    return error.what();
  }
  return "";
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
      some[i] = turned >> i & 1 ? Turned(parts[i]) : parts[i];
    }
    const shape::Mesh oriented = shape::OrientByNesting(Joined(some), "it");
    EXPECT_NEAR(shape::ComputeEnclosedVolume(oriented), solid, 1e-12) << turned;
    const Eigen::MatrixXi expected =
      Joined({ parts[0], parts[1], Turned(parts[2]), parts[3] }).Triangles;
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
  const shape::Surface inverted = Turned(ball);
  EXPECT_EQ(shape::OrientByNesting(inverted, "it").Triangles().rows(), ball.Triangles().rows());
  EXPECT_LT(shape::ComputeEnclosedVolume(inverted), 0.0);
  EXPECT_GT(shape::ComputeEnclosedVolume(shape::OrientByNesting(inverted, "it")), 0.0);
}

TEST(OrientByNesting, AComponentInTheHoleOfATorusIsNotInside)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.3, 48, 24), ball = Sphere(0.2, Origin);
  const shape::Mesh oriented = shape::OrientByNesting(Joined({ Turned(ball), torus }), "it");
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
  const std::string error = ErrorOf(Joined({ Sphere(1.0, Origin), Sphere(1.0, { 0.5, 0, 0 }) }));
  EXPECT_NE(error.find("touch or cross (those of points 0 and 642"), std::string::npos) << error;
  EXPECT_NE(error.find("turn Signed off"), std::string::npos) << error;
}

TEST(BoundaryDistance, OfAShellIsNegativeInTheShellAlone)
{
  const Eigen::MatrixXd points = RandomPoints(2000, 1.5);
  for (const shape::Mesh& inner : { Sphere(0.5, Origin), Turned(Sphere(0.5, Origin)) })
  {
    const shape::BoundaryDistance distance(Joined({ Turned(Sphere(1.0, Origin)), inner }));
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
  shape::Mesh open = Sphere(1.0, Origin);
  open.Triangles.conservativeResize(open.Triangles.rows() - 1, 3);
  const std::string error = ErrorOf(open);
  EXPECT_NE(error.find("1 open loop"), std::string::npos) << error;
  EXPECT_NE(error.find("turn Signed off"), std::string::npos) << error;
  EXPECT_NEAR(
    shape::BoundaryDistance(open, { false }).Evaluate(Eigen::MatrixXd::Zero(1, 3))(0), 1.0, 7e-3);
  open.Triangles.resize(0, 3);
  EXPECT_NE(ErrorOf(open).find("no polygons"), std::string::npos);
  shape::Mesh spoiled = Sphere(1.0, Origin);
  spoiled.Points(5, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ErrorOf(spoiled).find("Signed"), std::string::npos);
  EXPECT_NE(ErrorOf(spoiled).find("first at point 5"), std::string::npos);
  EXPECT_THROW(
    shape::BoundaryDistance(Sphere(1.0, Origin)).Evaluate(spoiled.Points), shape::InvalidInput);
}
