#include "Base/Errors.h"
#include "Mesh/PreciseMap.h"
#include "Search/ClosestPoint.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <numeric>

TEST(PreciseMap, PullsLinearFunctionsAndPushesByTheTranspose)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 20, 10);
  const shape::PreciseMap map =
    shape::SurfaceLocator(torus).Find(shape::RandomPlaces(torus, 50, 3));
  const Eigen::MatrixXd there = shape::Pulled(map, torus.Triangles, torus.Points);
  EXPECT_LT((there - shape::RandomPlaces(torus, 50, 3)).cwiseAbs().maxCoeff(), 1e-12);
  // <P f, g> = <f, P' g>
  const Eigen::MatrixXd g = Eigen::MatrixXd::Random(50, 2);
  const Eigen::MatrixXd f = torus.Points.leftCols(2);
  EXPECT_NEAR(shape::Pulled(map, torus.Triangles, f).cwiseProduct(g).sum(),
    f.cwiseProduct(shape::Pushed(map, torus.Triangles, g, torus.Points.rows())).sum(), 1e-12);
}

TEST(PreciseMap, ToPointsIsExactThereAndMainCornersGoBack)
{
  shape::Mesh torus = shapetest::Torus(2.0, 0.7, 20, 10);
  Eigen::VectorXi all(torus.Points.rows());
  std::iota(all.begin(), all.end(), 0);
  const shape::PreciseMap map = shape::MapToPoints(all, torus);
  EXPECT_EQ(shape::Pulled(map, torus.Triangles, torus.Points), torus.Points);
  EXPECT_EQ(shape::MainCorners(map, torus.Triangles), all);
  torus.Points.conservativeResize(torus.Points.rows() + 1, 3);
  torus.Points.bottomRows(1).setZero();
  const int unused = static_cast<int>(torus.Points.rows()) - 1;
  EXPECT_THROW(
    shape::MapToPoints(Eigen::VectorXi::Constant(1, unused), torus), shape::InvalidInput);
}
