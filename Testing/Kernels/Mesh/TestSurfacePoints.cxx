#include "Base/Errors.h"
#include "Mesh/SurfacePoints.h"
#include "Search/ClosestPoint.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <numeric>

TEST(SurfacePoints, PullsLinearFunctionsAndPushesByTheTranspose)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 20, 10);
  const shape::SurfacePoints map =
    shape::SurfaceLocator(torus).Find(shape::SampleRandomly(torus, 50, 3));
  const Eigen::MatrixXd there = shape::PullBack(map, torus.Triangles, torus.Points);
  EXPECT_LT((there - shape::SampleRandomly(torus, 50, 3)).cwiseAbs().maxCoeff(), 1e-12);
  // <P f, g> = <f, P' g>
  const Eigen::MatrixXd g = Eigen::MatrixXd::Random(50, 2);
  const Eigen::MatrixXd f = torus.Points.leftCols(2);
  EXPECT_NEAR(shape::PullBack(map, torus.Triangles, f).cwiseProduct(g).sum(),
    f.cwiseProduct(shape::PushForward(map, torus.Triangles, g, torus.Points.rows())).sum(), 1e-12);
}

TEST(SurfacePoints, ToPointsIsExactThereAndMainCornersGoBack)
{
  shape::Mesh torus = shapetest::Torus(2.0, 0.7, 20, 10);
  Eigen::VectorXi all(torus.Points.rows());
  std::iota(all.begin(), all.end(), 0);
  const shape::SurfacePoints map = shape::MakeSurfacePointsAtVertices(all, torus);
  EXPECT_EQ(shape::PullBack(map, torus.Triangles, torus.Points), torus.Points);
  EXPECT_EQ(shape::FindNearestCorners(map, torus.Triangles), all);
  torus.Points.conservativeResize(torus.Points.rows() + 1, 3);
  torus.Points.bottomRows(1).setZero();
  const int unused = static_cast<int>(torus.Points.rows()) - 1;
  EXPECT_THROW(shape::MakeSurfacePointsAtVertices(Eigen::VectorXi::Constant(1, unused), torus),
    shape::InvalidInput);
}
