// Facts checked: at the loop the values are the target's, beyond the width the feature's own; a
// difference that is the same all around stays so inwards; values in between lie between.

#include "CutPaste/Seam.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

/// A flat disk: its last `Corners` points are the loop.
struct Disk
{
  shape::Mesh Mesh = shapetest::FlatDisk(10);
  int Corners = 60;
  Eigen::MatrixXd Loop = this->Mesh.Points.bottomRows(60);
  Eigen::VectorXd Distances =
    (1.0 - this->Mesh.Points.rowwise().norm().array()).cwiseMax(0.0).matrix();
};

TEST(JoinBlend, ValuesAreTheTargetsAtTheLoopAndTheFeaturesWithin)
{
  const Disk disk;
  const Eigen::Index points = disk.Mesh.Points.rows();
  const Eigen::MatrixXd own = Eigen::MatrixXd::Random(points, 3);
  const Eigen::MatrixXd target = 5.0 * Eigen::MatrixXd::Random(disk.Corners, 3);
  const Eigen::MatrixXd blended = shape::BlendAtSeam(
    own, disk.Mesh.Points, target - own.bottomRows(disk.Corners), disk.Loop, disk.Distances, 0.45);
  EXPECT_LT((blended.bottomRows(disk.Corners) - target).cwiseAbs().maxCoeff(), 1e-14);
  for (Eigen::Index i = 0; i < points; ++i)
  {
    if (disk.Distances(i) >= 0.45)
    {
      EXPECT_EQ(blended.row(i), own.row(i));
    }
  }
}

TEST(JoinBlend, AConstantDifferenceFadesEvenly)
{
  const Disk disk;
  const Eigen::Index points = disk.Mesh.Points.rows();
  const Eigen::MatrixXd blended = shape::BlendAtSeam(Eigen::MatrixXd::Zero(points, 1),
    disk.Mesh.Points, Eigen::MatrixXd::Ones(disk.Corners, 1), disk.Loop, disk.Distances, 1.0);
  for (Eigen::Index i = 0; i < points; ++i)
  {
    const double left = 1.0 - disk.Distances(i) * disk.Distances(i);
    EXPECT_NEAR(blended(i), left * left * left, 1e-12);
  }
}

TEST(JoinBlend, DifferencesAreNotExceeded)
{
  const Disk disk;
  const Eigen::Index points = disk.Mesh.Points.rows();
  const Eigen::MatrixXd differences = Eigen::MatrixXd::Random(disk.Corners, 1);
  const Eigen::MatrixXd blended = shape::BlendAtSeam(Eigen::MatrixXd::Zero(points, 1),
    disk.Mesh.Points, differences, disk.Loop, disk.Distances, 2.0);
  EXPECT_LE(blended.maxCoeff(), differences.maxCoeff());
  EXPECT_GE(blended.minCoeff(), differences.minCoeff());
  const Eigen::MatrixXd none = shape::BlendAtSeam(Eigen::MatrixXd::Zero(points, 1),
    disk.Mesh.Points, differences, disk.Loop, disk.Distances, 0.0);
  EXPECT_EQ(none.cwiseAbs().maxCoeff(), 0.0);
}

} // namespace
