#include "Base/Errors.h"
#include "Correspondence/Evaluate/Congruence.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

using Relation = shape::Congruence::RelationType;

/// Turned, three times as large, elsewhere, and in another order.
shape::Mesh Moved(const shape::Mesh& mesh)
{
  shape::Mesh moved = shapetest::Renumber(mesh, 5).Mesh;
  moved.Points = 3.0 * moved.Points * shapetest::Rotation(2.5, { 1, -2, 1 }).transpose();
  moved.Points.rowwise() += Eigen::RowVector3d(10, -20, 30);
  return moved;
}

shape::Mesh Ellipsoid(const Eigen::Vector3d& axes, double angle)
{
  shape::Mesh mesh = shapetest::Icosphere(4);
  mesh.Points =
    mesh.Points * shapetest::Rotation(angle, { 1, 2, 3 }).transpose() * axes.asDiagonal();
  return mesh;
}

TEST(Congruence, OfTheSameTrianglesIsTheMotion)
{
  const shape::Mesh a = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  const auto same = shape::FindCongruence(a, Moved(a));
  EXPECT_EQ(same.Relation, Relation::Same);
  EXPECT_LT(same.MotionError, 1e-4);
  EXPECT_GT(same.ReflectionError, 0.01);
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() = 3.0 * shapetest::Rotation(2.5, { 1, -2, 1 });
  motion.topRightCorner<3, 1>() = Eigen::Vector3d(10, -20, 30);
  EXPECT_LT((same.Motion - motion).cwiseAbs().maxCoeff(), 1e-2);

  const auto image = shape::FindCongruence(a, Moved(shapetest::Mirrored(a)));
  EXPECT_EQ(image.Relation, Relation::MirrorImage);
  EXPECT_LT(image.ReflectionError, 1e-4);
  EXPECT_GT(image.MotionError, 0.01);
  motion.topLeftCorner<3, 3>().col(0) *= -1.0; // x is reflected first
  EXPECT_LT((image.Reflection - motion).cwiseAbs().maxCoeff(), 1e-2);
  EXPECT_LT(image.Reflection.topLeftCorner(3, 3).determinant(), 0.0);
}

TEST(Congruence, DoesNotDependOnTheTriangles)
{
  const shape::Mesh a = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity()),
                    b = shapetest::BumpySphere(4, shapetest::Rotation(0.7, { 3, -1, 1 }));
  EXPECT_EQ(shape::FindCongruence(a, Moved(b)).Relation, Relation::Same);
  EXPECT_EQ(
    shape::FindCongruence(a, Moved(shapetest::Mirrored(b))).Relation, Relation::MirrorImage);
}

TEST(Congruence, OfShapesWithLikeMoments)
{
  // Two like moments, three, and a mirror symmetry each: an ellipsoid of revolution, a cube, a
  // ball.
  const shape::Mesh cube = shapetest::Box({ 0, 0, 0 }, { 1, 1, 1 });
  for (const auto& [a, b] :
    { std::pair(Ellipsoid({ 1, 1, 2 }, 0.0), Ellipsoid({ 1, 1, 2 }, 0.7)),
      std::pair(Ellipsoid({ 2, 2, 1 }, 0.0), Ellipsoid({ 2, 2, 1 }, 0.7)),
      std::pair(Ellipsoid({ 1, 1, 1 }, 0.0), Ellipsoid({ 1, 1, 1 }, 0.7)), std::pair(cube, cube) })
  {
    EXPECT_EQ(shape::FindCongruence(a, Moved(b)).Relation, Relation::Both);
  }
  // A bump breaks the symmetry of revolution, but hardly moves the moments.
  shape::Mesh a = Ellipsoid({ 1, 1, 2 }, 0.0);
  for (Eigen::Index i = 0; i < a.Points.rows(); ++i)
  {
    for (const Eigen::RowVector3d& place :
      { Eigen::RowVector3d(1, 0, 0.3), Eigen::RowVector3d(0.6, 0.8, -0.5) })
    {
      a.Points.row(i) *= 1.0 + 0.3 * std::exp(-20.0 * (a.Points.row(i) - place).squaredNorm());
    }
  }
  EXPECT_EQ(shape::FindCongruence(a, Moved(a)).Relation, Relation::Same);
  EXPECT_EQ(
    shape::FindCongruence(a, Moved(shapetest::Mirrored(a))).Relation, Relation::MirrorImage);
}

TEST(Congruence, OtherShapesHaveNone)
{
  EXPECT_EQ(
    shape::FindCongruence(Ellipsoid({ 1, 1, 2 }, 0.0), Ellipsoid({ 1, 1.2, 2 }, 0.0)).Relation,
    Relation::None);
  const shape::Mesh sphere = shapetest::Icosphere(2);
  EXPECT_REFUSED(shape::FindCongruence(sphere, shape::Mesh()), "SurfaceB");
}

TEST(Congruence, OfModels)
{
  for (const char* name : { "bull", "elk", "hand", "bunny00" })
  {
    const shape::Mesh a = shapetest::ReadModel(name);
    EXPECT_EQ(static_cast<int>(shape::FindCongruence(a, Moved(a)).Relation) & 1, 1) << name;
    EXPECT_EQ(
      static_cast<int>(shape::FindCongruence(a, Moved(shapetest::Mirrored(a))).Relation) & 2, 2)
      << name;
  }
}

} // namespace
