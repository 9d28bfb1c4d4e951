#include "Base/Errors.h"
#include "Correspondence/Correspondence.h"
#include "Support/MatchingShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace
{

/// A surface, and a copy with other numbers in another pose, three times as large.
struct Copies
{
  shape::Mesh Original;
  shapetest::Renumbered Copy;

  explicit Copies(const shape::Mesh& mesh, unsigned int seed = 3)
    : Original(mesh)
    , Copy(shapetest::Renumber(mesh, seed))
  {
    this->Copy.Mesh.Points =
      3.0 * this->Copy.Mesh.Points * shapetest::Rotation(1.1, { 1.0, 2.0, -0.5 }).transpose();
  }

  Eigen::MatrixXd Wanted() const { return this->Copy.Mesh.Points(this->Copy.NewOf, Eigen::all); }

  /// Functions of the original at the points of the copy.
  Eigen::MatrixXd OnCopy(const Eigen::MatrixXd& values) const
  {
    Eigen::MatrixXd there(values.rows(), values.cols());
    there(this->Copy.NewOf, Eigen::all) = values;
    return there;
  }

  /// The map from the copy to the original.
  shape::SurfacePoints Back() const
  {
    Eigen::VectorXi old(this->Copy.NewOf.size());
    for (int i = 0; i < static_cast<int>(old.size()); ++i)
    {
      old(this->Copy.NewOf(i)) = i;
    }
    return shape::MakeSurfacePointsAtVertices(old, this->Original);
  }

  /// The distances from the right images, in roots of the area.
  Eigen::VectorXd Errors(const shape::SurfaceMaps& maps) const
  {
    return shapetest::MapErrors(maps.AToB, this->Copy.Mesh, this->Wanted()) /
      std::sqrt(shape::ComputePointAreas(this->Copy.Mesh).sum());
  }
};

Copies Elk()
{
  return Copies(shapetest::ReadModel("elk"));
}

shape::CorrespondenceOptions FunctionalOptions()
{
  shape::CorrespondenceOptions options;
  options.Method = shape::CorrespondenceOptions::MethodType::FunctionalMap;
  return options;
}

TEST(
  FunctionalMatrix, OfACopyIsItsScaleTimesAnOrthogonalMatrixThatTakesCoefficientsToThoseOfTheImage)
{
  const Copies pair = Elk();
  const shape::FunctionalMatrix map =
    shape::ComputeFunctionalMatrix(pair.Original, pair.Copy.Mesh, pair.Back(), 30);
  const Eigen::MatrixXd unit = map.Matrix / 3.0;
  EXPECT_LT((unit.transpose() * unit - Eigen::MatrixXd::Identity(30, 30)).norm(), 1e-6);
  // Its definition, without the class that interpolates.
  const Eigen::MatrixXd images = pair.OnCopy(map.OfA.Eigenfunctions);
  const Eigen::MatrixXd wanted =
    map.OfB.Eigenfunctions.transpose() * map.OfB.Masses.asDiagonal() * images;
  EXPECT_LT((map.Matrix - wanted).norm(), 1e-9);
  // A band-limited function arrives as it is.
  const Eigen::MatrixXd function =
    map.OfA.Eigenfunctions * Eigen::VectorXd::LinSpaced(30, 1.0, 2.0);
  EXPECT_LT((shape::TransferFunctions(map, function) - pair.OnCopy(function)).cwiseAbs().maxCoeff(),
    1e-6 * function.cwiseAbs().maxCoeff());
}

TEST(FunctionalGuide, AMatrixIsTheMapOfThePointsWithoutRefinementAndWithIt)
{
  const Copies pair = Elk();
  shape::CorrespondenceOptions options = FunctionalOptions();
  options.Functional.Guide.Matrix =
    shape::ComputeFunctionalMatrix(pair.Original, pair.Copy.Mesh, pair.Back(), 60).Matrix;
  options.FunctionalMatrix = true;
  options.NumberOfEigenpairs = 60;
  for (const int step : { 0, 6 })
  {
    options.Functional.Refinement.Step = step;
    const shape::CorrespondenceResult result =
      shape::ComputeCorrespondence(pair.Original, pair.Copy.Mesh, {}, options);
    EXPECT_LT(pair.Errors(result.Maps).maxCoeff(), 1e-6) << step;
    EXPECT_FALSE(result.Found);
    // What comes out can go in.
    EXPECT_LT((result.Matrix.Matrix - options.Functional.Guide.Matrix).norm(), 1e-4) << step;
  }
  // A small matrix is enough for a start, also on coarse copies, whose bases are others.
  options.Functional.Guide.Matrix = options.Functional.Guide.Matrix.topLeftCorner(20, 20).eval();
  options.NumberOfEigenpairs = 120;
  EXPECT_LT(
    pair.Errors(shape::ComputeCorrespondence(pair.Original, pair.Copy.Mesh, {}, options).Maps)
      .mean(),
    1e-6);
  options.CoarsePoints = static_cast<int>(pair.Original.Points.rows()) / 2;
  EXPECT_LT(
    pair.Errors(shape::ComputeCorrespondence(pair.Original, pair.Copy.Mesh, {}, options).Maps)
      .mean(),
    0.02);
}

TEST(FunctionalGuide, GivenDescriptorsRecoverTheMapThatTheyComeFrom)
{
  const Copies pair = Elk();
  shape::CorrespondenceOptions options = FunctionalOptions();
  options.Functional.Use = shape::FunctionalMapOptions::DescriptorType::Given;
  options.Functional.Guide.DescriptorsOfA = pair.Original.Points;
  options.Functional.Guide.DescriptorsOfB = pair.OnCopy(pair.Original.Points);
  const shape::CorrespondenceResult result =
    shape::ComputeCorrespondence(pair.Original, pair.Copy.Mesh, {}, options);
  EXPECT_LT(pair.Errors(result.Maps).maxCoeff(), 1e-6);
  EXPECT_TRUE(result.Used.empty());

  options.Functional.Guide = {};
  EXPECT_THROW(
    shape::ComputeCorrespondence(pair.Original, pair.Copy.Mesh, {}, options), shape::InvalidInput);
}

/// An ellipsoid, which three turns by 180 degrees map onto itself, its triangles included.
shape::Mesh Ellipsoid()
{
  shape::Mesh mesh = shapetest::Icosphere(4);
  mesh.Points.col(0) *= 2.0;
  mesh.Points.col(1) *= 1.5;
  return mesh;
}

TEST(FunctionalGuide, RegionsDecideBetweenTheImagesOfASymmetricShape)
{
  const shape::Mesh mesh = Ellipsoid();
  // Two caps, each of which two of the turns move to the other side.
  Eigen::VectorXi ids(mesh.Points.rows());
  for (Eigen::Index i = 0; i < ids.size(); ++i)
  {
    ids(i) = mesh.Points(i, 0) > 1.2 ? 7 : mesh.Points(i, 1) > 1.0 ? 4 : 0;
  }
  for (const unsigned int seed : { 1U, 2U, 3U, 4U })
  {
    const Copies pair(mesh, seed);
    const shape::RegionIndicators regions = shape::ComputeRegionIndicators(pair.Original,
      { ids, true }, pair.Copy.Mesh, { pair.OnCopy(ids.cast<double>()).col(0).cast<int>(), true });
    ASSERT_EQ(regions.OfA.cols(), 3);
    EXPECT_NEAR(regions.OfA.rowwise().sum().minCoeff(), 1.0, 1e-12);
    shape::CorrespondenceOptions options = FunctionalOptions();
    options.Functional.Guide.DescriptorsOfA = regions.OfA;
    options.Functional.Guide.DescriptorsOfB = regions.OfB;
    const shape::CorrespondenceResult result =
      shape::ComputeCorrespondence(pair.Original, pair.Copy.Mesh, {}, options);
    EXPECT_LT(pair.Errors(result.Maps).mean(), 0.02) << seed;
  }
}

TEST(FunctionalGuide, RegionsOfTrianglesAreSharesOfTheAreaAroundPoints)
{
  const shape::Mesh mesh = shapetest::FlatSquare(4, 0.0);
  const Eigen::MatrixXd centres = shape::ComputeCentroids(mesh);
  Eigen::VectorXi left(mesh.Triangles.rows()), other(mesh.Triangles.rows());
  const double middle = mesh.Points.col(0).mean();
  for (Eigen::Index t = 0; t < left.size(); ++t)
  {
    left(t) = centres(t, 0) < middle ? 1 : 2;
    other(t) = left(t) == 1 ? 1 : 9; // 2 and 9 are on one surface only
  }
  const shape::RegionIndicators regions =
    shape::ComputeRegionIndicators(mesh, { left, false }, mesh, { other, false });
  ASSERT_EQ(regions.OfA.cols(), 1);
  EXPECT_EQ(regions.OfA, regions.OfB);
  // The integral of the indicator is the area of the region.
  EXPECT_NEAR(
    shape::ComputePointAreas(mesh).dot(regions.OfA.col(0)) / shape::ComputePointAreas(mesh).sum(),
    0.5, 1e-12);
  EXPECT_THROW(shape::ComputeRegionIndicators(
                 mesh, { left, false }, mesh, { Eigen::VectorXi::Constant(left.size(), 5), false }),
    shape::InvalidInput);
}

TEST(FunctionalGuide, ACurveAsAWholeRecoversTheMap)
{
  const Copies pair = Elk();
  // The points nearest to a plane through the middle and a corner of the box, on one side of it.
  const Eigen::RowVector3d centre = pair.Original.Points.colwise().mean();
  const double width = shape::ComputeBoxDiagonal(pair.Original.Points);
  shape::Landmarks curve;
  for (int i = 0; i < static_cast<int>(pair.Original.Points.rows()); ++i)
  {
    const Eigen::RowVector3d from = pair.Original.Points.row(i) - centre;
    if (std::abs(from(0) - from(1)) < 0.01 * width && from(2) > 0.0)
    {
      curve.push_back({ i, pair.Copy.NewOf(i) });
    }
  }
  ASSERT_GT(curve.size(), 10U);
  shape::FunctionalMapOptions options;
  options.Use = shape::FunctionalMapOptions::DescriptorType::Given;
  options.Guide.Curves = { curve };
  const shape::SurfaceMaps maps =
    shape::ComputeFunctionalMap(pair.Original, pair.Copy.Mesh, {}, options);
  EXPECT_LT(pair.Errors(maps).mean(), 1e-3);
}

TEST(FunctionalGuide, RefusesMatricesThatDoNotFitAndPartsThatItCannotLocate)
{
  const shape::Mesh mesh = shapetest::BumpySphere(2, Eigen::Matrix3d::Identity());
  shape::CorrespondenceOptions options = FunctionalOptions();
  const auto refused = [&](const Eigen::MatrixXd& matrix)
  {
    options.Functional.Guide.Matrix = matrix;
    EXPECT_THROW(shape::ComputeCorrespondence(mesh, mesh, {}, options), shape::InvalidInput);
  };
  refused(Eigen::MatrixXd::Identity(20, mesh.Points.rows() + 1));
  refused(Eigen::MatrixXd::Identity(mesh.Points.rows() + 1, mesh.Points.rows() + 1));
  Eigen::MatrixXd broken = Eigen::MatrixXd::Identity(20, 20);
  broken(3, 4) = std::numeric_limits<double>::quiet_NaN();
  refused(broken);
  options.Part = shape::CorrespondenceOptions::PartType::SurfaceA;
  refused(Eigen::MatrixXd::Identity(20, 20));
}

} // namespace
