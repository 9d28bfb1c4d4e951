#include "Base/Errors.h"
#include "Correspondence/Evaluate/MapDifference.h"
#include "Search/ClosestPoint.h"
#include "Support/MatchingShapes.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using shapetest::IdentityMap;

/// Each point to itself.
shape::MapDifferenceOptions Pairs(int count)
{
  shape::MapDifferenceOptions options;
  options.NumberOfEigenpairs = count;
  return options;
}

/// How far the operators are from factor V and from the identity beside the constant.
double FarFrom(const shape::MapDifferenceResult& result, double area)
{
  const Eigen::Index k = result.Area.Matrix.rows();
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Identity(k, k);
  const double far = (result.Area.Matrix / area - wanted).cwiseAbs().maxCoeff();
  wanted(0, 0) = 0.0;
  return std::max(far, (result.Conformal.Matrix - wanted).cwiseAbs().maxCoeff());
}

/// The conformal map of the unit sphere that takes the plane of the stereographic projection from
/// the north pole to `scale` times itself.
Eigen::MatrixXd Moebius(const Eigen::MatrixXd& points, double scale)
{
  Eigen::MatrixXd images(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const double up = 1.0 + points(i, 2), down = 1.0 - points(i, 2);
    const double norm = down + scale * scale * up;
    images.row(i) << 2.0 * scale * points(i, 0) / norm, 2.0 * scale * points(i, 1) / norm,
      (scale * scale * up - down) / norm;
  }
  return images;
}

} // namespace

TEST(MapDifference, OfTheSameShapeIsTheIdentityAndScaleShowsInAreasOnly)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 40, 20);
  for (const double scale : { 1.0, 3.0 })
  {
    shape::Mesh scaled = torus;
    scaled.Points *= scale;
    const shape::MapDifferenceResult result =
      shape::MapDifference(torus, scaled, IdentityMap(torus), Pairs(20));
    EXPECT_LT(FarFrom(result, scale * scale), 1e-6);
    EXPECT_LT((result.Area.Field.array() - scale * scale).abs().maxCoeff(), 1e-6);
    EXPECT_LT((result.Conformal.Field.array() - 1.0).abs().maxCoeff(), 1e-6);
    EXPECT_EQ(result.Undetermined, 0);
  }
}

TEST(MapDifference, OfAShapeWithATriangleWithoutAreaIsTheIdentity)
{
  for (int edge = 0; edge < 3; ++edge)
  {
    const shape::Mesh split =
      shapetest::WithFlatTriangle(shapetest::Torus(2.0, 0.7, 20, 10), 30, edge);
    EXPECT_LT(
      FarFrom(shape::MapDifference(split, split, IdentityMap(split), Pairs(12)), 1.0), 1e-6);
  }
}

TEST(MapDifference, OfABentPlateIsTheIdentity)
{
  const shape::Mesh flat = shapetest::FlatSquare(50, 0.2);
  shape::Mesh bent = flat;
  bent.Points.col(0) = flat.Points.col(0).array().sin();
  bent.Points.col(2) = flat.Points.col(0).array().cos();
  EXPECT_LT(FarFrom(shape::MapDifference(flat, bent, IdentityMap(bent), Pairs(15)), 1.0), 1e-3);
}

TEST(MapDifference, OfOtherTrianglesOfTheSameShapeIsNearTheIdentity)
{
  const shape::Mesh first = shapetest::Icosphere(4);
  shape::Mesh second = shapetest::Icosphere(4);
  second.Points *= Eigen::AngleAxisd(1.0, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  const shape::ClosestPoints map = shape::SurfaceLocator(second).Find(first.Points);
  EXPECT_LT(FarFrom(shape::MapDifference(first, second, map, Pairs(16)), 1.0), 0.02);
}

TEST(MapDifference, OfAConformalMapIsInAreasAlone)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const shape::ClosestPoints map = shape::SurfaceLocator(sphere).Find(Moebius(sphere.Points, 1.3));
  // The ratio of areas is (2 s / (1 - z + s^2 (1 + z)))^2.
  const Eigen::ArrayXd z = sphere.Points.col(2).array(),
                       wanted = (2.6 / (1.0 - z + 1.69 * (1.0 + z))).square();
  EXPECT_GT(wanted.maxCoeff() / wanted.minCoeff(), 2.8);
  double before = 1.0;
  for (const int pairs : { 9, 25, 81 }) // the more functions, the narrower what is averaged over
  {
    const shape::MapDifferenceResult result =
      shape::MapDifference(sphere, sphere, map, Pairs(pairs));
    EXPECT_LT((result.Conformal.Field.array() - 1.0).abs().maxCoeff(), 0.015);
    const double error = (result.Area.Field.array() / wanted - 1.0).abs().maxCoeff();
    EXPECT_LT(error, 0.7 * before);
    before = error;
  }
  EXPECT_LT(before, 0.1);
}

TEST(MapDifference, OfAStretchIsItsDistortion)
{
  // A flat torus would have no ends; on a plate the middle is far enough from them.
  const shape::Mesh plate = shapetest::FlatSquare(50, 0.2);
  shape::Mesh stretched = plate;
  stretched.Points.col(0) *= 2.0;
  const shape::MapDifferenceResult result =
    shape::MapDifference(plate, stretched, IdentityMap(plate), Pairs(60));
  EXPECT_LT((result.Area.Field.array() - 2.0).abs().maxCoeff(), 0.01);
  Eigen::Index middle = 0;
  plate.Points.rowwise().squaredNorm().minCoeff(&middle);
  EXPECT_NEAR(result.Conformal.Field(middle), 0.5 * (2.0 + 0.5), 0.05);
  // Along x and across it: the least and the largest there can be.
  EXPECT_NEAR(result.Conformal.Eigenvalues.maxCoeff(), 2.0, 1e-3);
  EXPECT_NEAR(result.Conformal.Eigenvalues.minCoeff(), 0.5, 1e-3);
}

TEST(MapDifference, ShowsWhereABumpIs)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  shape::Mesh bumped = sphere;
  const Eigen::VectorXd heights = sphere.Points.col(2);
  for (Eigen::Index i = 0; i < bumped.Points.rows(); ++i)
  {
    bumped.Points.row(i) *= 1.0 + 0.5 * std::exp(8.0 * (heights(i) - 1.0));
  }
  const shape::MapDifferenceResult result =
    shape::MapDifference(sphere, bumped, IdentityMap(sphere), Pairs(50));
  Eigen::Index top = 0, side = 0;
  heights.maxCoeff(&top);
  EXPECT_GT(result.Area.Field.maxCoeff(), 1.5);
  EXPECT_GT(result.Conformal.Field.maxCoeff(), 1.02);
  const Eigen::VectorXd areas = shape::ComputePointAreas(sphere);
  const Eigen::VectorXd leading = result.Area.Eigenfunctions.col(0).cwiseAbs2();
  const Eigen::VectorXd above = (heights.array() > 0.5).cast<double>();
  EXPECT_NEAR(areas.dot(leading), 1.0, 0.02);
  EXPECT_GT(areas.cwiseProduct(above).dot(leading), 0.9) << "a quarter of the sphere";
  for (Eigen::Index i = 0; i < heights.size(); ++i)
  {
    side += heights(i) < -0.5;
    EXPECT_TRUE(heights(i) > -0.5 || std::abs(result.Area.Field(i) - 1.0) < 0.03);
    EXPECT_TRUE(heights(i) > -0.5 || std::abs(result.Conformal.Field(i) - 1.0) < 0.03);
  }
  EXPECT_GT(side, 500);
  EXPECT_GT(result.Area.Field(top), 1.5);
}

TEST(MapDifference, SaysHowMuchOfTheOtherSurfaceIsNotReached)
{
  // Half a plate onto the same half: about half of the functions of the whole are not known.
  const shape::Mesh plate = shapetest::FlatSquare(40, 0.1);
  shape::Mesh half = plate;
  std::vector<int> kept;
  for (int t = 0; t < static_cast<int>(plate.Triangles.rows()); ++t)
  {
    if (shape::GetCorners(plate, t).col(0).mean() < 0.0)
    {
      kept.push_back(t);
    }
  }
  half.Triangles = plate.Triangles(kept, Eigen::all).eval();
  const shape::MapDifferenceResult result =
    shape::MapDifference(half, plate, IdentityMap(plate), Pairs(30));
  EXPECT_GT(result.Undetermined, 15);
  EXPECT_LT(result.Undetermined, 45);
  for (const Eigen::VectorXd& field : { result.Area.Field, result.Conformal.Field })
  {
    EXPECT_TRUE(field.allFinite());
  }
}

TEST(MapDifference, RefusesMoreFunctionsThanPoints)
{
  const shape::Mesh sphere = shapetest::Icosphere(1);
  EXPECT_THROW(
    shape::MapDifference(sphere, sphere, IdentityMap(sphere), Pairs(43)), shape::InvalidInput);
  EXPECT_THROW(
    shape::MapDifference(sphere, sphere, IdentityMap(sphere), Pairs(1)), shape::InvalidInput);
  EXPECT_THROW(shape::MapDifference(sphere, sphere, IdentityMap(sphere), Pairs(10),
                 shape::Progress([](double) { return false; })),
    shape::Aborted);
}
