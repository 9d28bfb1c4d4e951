// Facts checked: a feature that stands at an angle leaves its loop along the tangent planes that
// are asked for; points beyond the width and those of the loop stay; nothing is turned by a share
// of 0, and all turns with the space; points at the same place do no harm.

#include "CutPaste/Seam.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{

/// A cone over the unit circle, as steep as 30 degrees; the loop is its rim.
struct Cone
{
  Cone()
    : Surface(shapetest::FlatDisk(10))
    , Fans(this->Surface.Triangles, this->Surface.Points.rows())
    , Loop(60)
  {
    this->Distances = 1.0 - this->Surface.Points.rowwise().norm().array();
    this->Distances.tail(60).setZero();
    this->Surface.Points.col(2) = std::tan(M_PI / 6.0) * this->Distances;
    std::iota(this->Loop.begin(), this->Loop.end(), Surface.Points.rows() - 60);
    this->Up = Eigen::RowVector3d(0, 0, 1).replicate(60, 1);
  }

  Eigen::MatrixXd Turned(double share, double width) const
  {
    Eigen::MatrixXd points = this->Surface.Points;
    shape::SeamNormals(this->Surface, this->Fans, { this->Loop }, this->Distances, width)
      .Apply(points, this->Up, share);
    return points;
  }

  shape::Mesh Surface;
  shape::TriangleFans Fans;
  std::vector<int> Loop;
  Eigen::VectorXd Distances;
  Eigen::MatrixXd Up;
};

TEST(SeamNormals, TheFeatureLeavesTheLoopAlongTheTangentPlanes)
{
  const Cone cone;
  const Eigen::MatrixXd turned = cone.Turned(1.0, 0.45);
  const Eigen::MatrixXd half = cone.Turned(0.5, 0.45);
  for (Eigen::Index i = 0; i < turned.rows(); ++i)
  {
    const double distance = cone.Distances(i), height = cone.Surface.Points(i, 2);
    if (distance < 0.11) // the loop and the ring beside it
    {
      EXPECT_NEAR(turned(i, 2), 0.0, 1e-15);
      EXPECT_LE(half(i, 2), 0.55 * height);
      EXPECT_GE(half(i, 2), 0.45 * height);
    }
    else if (distance < 0.45)
    {
      EXPECT_LT(turned(i, 2), height);
      EXPECT_GT(turned(i, 2), 0.0);
    }
    else
    {
      EXPECT_EQ(turned.row(i), cone.Surface.Points.row(i));
    }
  }
  // Turned, not pushed: the ring is as far from the loop as it was.
  const Eigen::Index ring = turned.rows() - 61, loop = turned.rows() - 1;
  EXPECT_NEAR((turned.row(ring) - turned.row(loop)).norm(),
    (cone.Surface.Points.row(ring) - cone.Surface.Points.row(loop)).norm(), 2e-3);
}

TEST(SeamNormals, NothingIsTurnedByAShareOfZero)
{
  const Cone cone;
  EXPECT_LT((cone.Turned(0.0, 0.45) - cone.Surface.Points).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(SeamNormals, TurnsWithTheSpace)
{
  const Cone cone;
  const shape::SeamNormals turning(cone.Surface, cone.Fans, { cone.Loop }, cone.Distances, 0.45);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.3, Eigen::Vector3d(2, -1, 3).normalized()).toRotationMatrix();
  const Eigen::RowVector3d shift(3, -7, 2);
  Eigen::MatrixXd points = (cone.Surface.Points * turn.transpose()).rowwise() + shift;
  turning.Apply(points, cone.Up * turn.transpose(), 1.0);
  const Eigen::MatrixXd wanted = (cone.Turned(1.0, 0.45) * turn.transpose()).rowwise() + shift;
  EXPECT_LT((points - wanted).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(SeamNormals, LeansOutwardsAndBack)
{
  // The ring stands outside the loop, as if folded over: it comes back into the plane, inside.
  Cone cone;
  const Eigen::Index last = cone.Surface.Points.rows() - 60;
  for (Eigen::Index i = last - 54; i < last; ++i)
  {
    cone.Surface.Points.row(i) << 1.05 * cone.Surface.Points.row(i).head(2).normalized(), 0.3;
  }
  const Eigen::MatrixXd turned = cone.Turned(1.0, 0.0);
  for (Eigen::Index i = last - 54; i < last; ++i)
  {
    EXPECT_NEAR(turned(i, 2), 0.0, 1e-15);
    EXPECT_LT(turned.row(i).norm(), 0.75);
    EXPECT_GT(turned.row(i).norm(), 0.65);
  }
}

TEST(SeamNormals, PointsAtTheSamePlaceDoNoHarm)
{
  Cone cone;
  const Eigen::Index last = cone.Surface.Points.rows() - 1;
  cone.Surface.Points.row(last - 60) = cone.Surface.Points.row(last);
  cone.Surface.Points.row(last - 30) = cone.Surface.Points.row(last - 31);
  cone.Surface.Points.row(last - 130) = cone.Surface.Points.row(last - 7); // not next to the loop
  EXPECT_TRUE(cone.Turned(1.0, 0.45).allFinite());
}

} // namespace
