#include "Hex/Features/Private/QuadPatches.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

namespace
{

/// The six quads of a cube around a place, half as long as `half`, with points from `first` on.
void AddCube(
  double middle, double half, Eigen::Index first, Eigen::MatrixXd& points, Eigen::MatrixXi& quads)
{
  for (int i = 0; i < 8; ++i)
  {
    points.row(first + i) << middle + half * (i & 1 ? 1 : -1), half * (i & 2 ? 1 : -1),
      half * (i & 4 ? 1 : -1);
  }
  Eigen::Matrix<int, 6, 4> sides;
  sides << 0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5;
  quads.middleRows(first / 8 * 6, 6) = sides.array() + static_cast<int>(first);
}

/// Cubes at places on the x axis.
Eigen::VectorXi PatchesOfCubes(const Eigen::VectorXd& midpoints)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  shape::SurfaceFeatures halves;
  halves.Patches = 2;
  halves.PatchOf.resize(ball.Triangles.rows());
  for (Eigen::Index f = 0; f < ball.Triangles.rows(); ++f)
  {
    halves.PatchOf(f) = ball.Points(ball.Triangles.row(f), 0).mean() > 0.0 ? 1 : 0;
  }
  Eigen::MatrixXd points(8 * midpoints.size(), 3);
  Eigen::MatrixXi quads(6 * midpoints.size(), 4);
  for (Eigen::Index i = 0; i < midpoints.size(); ++i)
  {
    AddCube(midpoints(i), 0.1, 8 * i, points, quads);
  }
  const std::vector<shape::Mesh> patches = shape::SplitIntoPatches(ball, halves);
  return shape::AssignQuadsToPatches(
    points, shape::QuadSurface(quads), ball, halves, { patches.begin(), patches.end() });
}

} // namespace

TEST(QuadPatches, QuadsTakeThePatchThatIsNearest)
{
  Eigen::VectorXi wanted(12);
  wanted << Eigen::VectorXi::Zero(6), Eigen::VectorXi::Ones(6);
  EXPECT_EQ(PatchesOfCubes(Eigen::Vector2d(-1.0, 1.0)), wanted);
}

// The third cube is nearest to a patch that has a larger or equal piece already.
TEST(QuadPatches, AComponentThatNoPatchReachesIsTold)
{
  EXPECT_EQ(PatchesOfCubes(Eigen::Vector3d(-1.0, 1.0, 1.5)).size(), 0);
}
