#include "Base/Errors.h"
#include "Quality/ConformalDistortion.h"
#include "Quality/MapQuality.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using shape::CellShape;
using shape::CellSimplices;
using shape::LargestMeasure;
using shape::MapMeasure;
using shape::MapQualityResult;
using shape::MapQualitySums;

namespace
{

/// One cell of each solid shape, convex and of no symmetry but affine to the regular one.
struct Solid
{
  CellShape Shape;
  Eigen::MatrixXd Points;
  double Volume;
};

std::vector<Solid> RegularSolids()
{
  const auto matrix = [](std::initializer_list<double> values)
  {
    Eigen::MatrixXd points(values.size() / 3, 3);
    Eigen::Index i = 0;
    for (const double value : values)
    {
      points(i / 3, i % 3) = value;
      ++i;
    }
    return points;
  };
  return { { CellShape::Tetrahedron, matrix({ 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 }), 1.0 / 6.0 },
    { CellShape::Pyramid, matrix({ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.3, 0.4, 1 }), 1.0 / 3.0 },
    { CellShape::Wedge, matrix({ 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 1, 1, 1, 0, 1 }), 0.5 },
    { CellShape::Hexahedron,
      matrix({ 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1 }), 1.0 } };
}

CellSimplices OneCell(CellShape shape, int points)
{
  std::vector<int> ids(points);
  std::iota(ids.begin(), ids.end(), 0);
  CellSimplices cells;
  cells.Add(shape, ids.data());
  cells.EndCell();
  return cells;
}

CellSimplices CellsOf(const shape::Mesh& mesh)
{
  CellSimplices cells;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = mesh.Triangles.row(t);
    cells.Add(CellShape::Triangle, corners.data());
    cells.EndCell();
  }
  return cells;
}

MapQualityResult Quality(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const CellSimplices& cells)
{
  return shape::EvaluateMapQuality(
    points, images, cells, shape::ComputeMapExtent(points, images, cells));
}

MapQualitySums SumsOf(const MapQualityResult& result)
{
  MapQualitySums sums;
  sums.Add(result, Eigen::VectorXi::Ones(result.Sizes.size()));
  return sums;
}

/// The measures in their order, from the singular values; the last one has the determinant's sign.
Eigen::RowVectorXd Expected(const Eigen::VectorXd& s)
{
  const double d = s.size(), squares = s.squaredNorm(), product = s.prod();
  const double inverses = s.cwiseInverse().squaredNorm(), size = std::abs(product);
  const Eigen::ArrayXd lengths = s.array().abs();
  const double area = 0.5 * (size + 1.0 / size);
  // In solids: the product of (s_i / s_k + s_k / s_i) over the three pairs.
  double angles = 1.0;
  for (Eigen::Index i = 0; i < s.size(); ++i)
  {
    for (Eigen::Index k = i + 1; k < s.size(); ++k)
    {
      angles *= 0.5 * (lengths(i) / lengths(k) + lengths(k) / lengths(i));
    }
  }
  Eigen::RowVectorXd values(shape::MapMeasureCount);
  values << product, squares / 2.0, squares + inverses, squares / (d * std::pow(size, 2.0 / d)),
    (s.array() - 1.0).square().sum(), lengths.log().square().sum(), std::exp(angles + 0.5 * area),
    area, std::sqrt(inverses / d), 1.0 / lengths.minCoeff(), lengths.minCoeff(), lengths.maxCoeff();
  return values;
}

Eigen::Matrix3d Rotation(double angle)
{
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

void ExpectMeasures(
  const MapQualityResult& result, const Eigen::RowVectorXd& expected, double scale)
{
  for (Eigen::Index cell = 0; cell < result.Measures.rows(); ++cell)
  {
    const Eigen::ArrayXd apart = (result.Measures.row(cell) - expected).cwiseAbs().transpose();
    EXPECT_LT(apart.head(5).maxCoeff(), 1e-12 * scale) << result.Measures.row(cell);
    // AMIPS grows exponentially.
    EXPECT_LT((apart / expected.transpose().array().abs().max(1.0)).maxCoeff(), 1e-12 * scale)
      << result.Measures.row(cell) << "\nexpected\n"
      << expected;
  }
}

/// [0, 1] x [0, 1] in cells x cells squares of two triangles.
shape::Mesh Square(int cells)
{
  shape::Mesh mesh{ Eigen::MatrixXd::Zero((cells + 1) * (cells + 1), 3),
    Eigen::MatrixXi(2 * cells * cells, 3) };
  int t = 0;
  for (int i = 0; i <= cells; ++i)
  {
    for (int j = 0; j <= cells; ++j)
    {
      const int a = i * (cells + 1) + j, b = a + cells + 1;
      mesh.Points.row(a) << static_cast<double>(i) / cells, static_cast<double>(j) / cells, 0.0;
      if (i < cells && j < cells)
      {
        mesh.Triangles.row(t++) << a, b, b + 1;
        mesh.Triangles.row(t++) << a, b + 1, a + 1;
      }
    }
  }
  return mesh;
}

} // namespace

TEST(MapQuality, OfLinearMapsOfSolidsIsThatOfTheirSingularValues)
{
  for (const Solid& solid : RegularSolids())
  {
    const CellSimplices cells = OneCell(solid.Shape, static_cast<int>(solid.Points.rows()));
    for (const Eigen::Vector3d& s : { Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(2, 2, 2),
           Eigen::Vector3d(3, 1, 0.25), Eigen::Vector3d(1, 1, -1), Eigen::Vector3d(2, 1.5, -0.5) })
    {
      const Eigen::Matrix3d map = Rotation(0.8) * s.asDiagonal() * Rotation(-1.9);
      const Eigen::MatrixXd images =
        (solid.Points * map.transpose()).rowwise() + Eigen::RowVector3d(5, 6, 7);
      const MapQualityResult result = Quality(solid.Points, images, cells);
      ExpectMeasures(result, Expected(s), 100.0);
      EXPECT_EQ(result.Flipped(0), s.prod() < 0.0);
      EXPECT_EQ(result.Degenerate(0), 0);
      EXPECT_NEAR(result.Sizes(0), solid.Volume, 1e-15);
    }
  }
}

TEST(MapQuality, OfIsometriesIsFourForSurfacesAndSixForSolids)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 30, 20);
  const MapQualityResult surface =
    Quality(torus.Points, torus.Points * Rotation(2.0).transpose(), CellsOf(torus));
  ExpectMeasures(surface, Expected(Eigen::Vector2d::Ones()), 100.0);
  EXPECT_EQ(surface.Flipped.sum(), 0);
  EXPECT_NEAR(
    surface.Sizes.sum(), shape::ComputeAreaVectors(torus).rowwise().norm().sum() / 2.0, 1e-12);
  const Solid cube = RegularSolids().back();
  const MapQualityResult solid =
    Quality(cube.Points, cube.Points * Rotation(2.0).transpose(), OneCell(cube.Shape, 8));
  ExpectMeasures(solid, Expected(Eigen::Vector3d::Ones()), 100.0);
}

TEST(MapQuality, OfAShearHasTheSingularValuesOfTheGoldenRatio)
{
  // [1 1; 0 1] has the singular values (sqrt(5) + 1) / 2 and (sqrt(5) - 1) / 2.
  const double golden = (std::sqrt(5.0) + 1.0) / 2.0;
  const shape::Mesh mesh = Square(3);
  Eigen::MatrixXd images = mesh.Points;
  images.col(0) += mesh.Points.col(1);
  const MapQualityResult flat = Quality(mesh.Points, images, CellsOf(mesh));
  ExpectMeasures(flat, Expected(Eigen::Vector2d(golden, 1.0 / golden)), 10.0);
  // The same out of the plane, at any turn of both: and what ConformalDistortion says.
  const Eigen::MatrixXd a = mesh.Points * Rotation(0.7), b = images * Rotation(1.3);
  const MapQualityResult turned = Quality(a, b, CellsOf(mesh));
  EXPECT_LT((turned.Measures - flat.Measures).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::VectorXd conformal = shape::ComputeConformalDistortion(mesh, images);
  EXPECT_LT((conformal - flat.Measures.col(static_cast<int>(MapMeasure::ConformalDistortion)))
              .cwiseAbs()
              .maxCoeff(),
    1e-12);
}

TEST(MapQuality, AReflectionOfThePlaneOrTheSphereIsFlippedEverywhere)
{
  const shape::Mesh mesh = Square(4);
  Eigen::MatrixXd mirrored = mesh.Points;
  mirrored.col(0) *= -1.0;
  ExpectMeasures(
    Quality(mesh.Points, mirrored, CellsOf(mesh)), Expected(Eigen::Vector2d(1.0, -1.0)), 1.0);
  // A plane that faces down is mapped to itself without a flip.
  shape::Mesh down = mesh;
  down.Triangles.col(0).swap(down.Triangles.col(1));
  EXPECT_EQ(Quality(down.Points, down.Points, CellsOf(down)).Flipped.sum(), 0);
  EXPECT_EQ(Quality(down.Points, mirrored, CellsOf(down)).Flipped.sum(), 32);

  const shape::Mesh sphere = shapetest::Icosphere(2);
  EXPECT_EQ(Quality(sphere.Points, -sphere.Points, CellsOf(sphere)).Flipped.sum(), 320);
  // From an ellipsoid the sphere's triangles are compared with the radius alone.
  const Eigen::MatrixXd longer = sphere.Points * Eigen::RowVector3d(2.0, 1.0, 1.0).asDiagonal();
  EXPECT_EQ(Quality(longer, sphere.Points, CellsOf(sphere)).Flipped.sum(), 0);
  EXPECT_EQ(Quality(longer, -sphere.Points, CellsOf(sphere)).Flipped.sum(), 320);
}

TEST(MapQuality, OneTriangleFoldedOverIsFoundOnPlaneSphereAndAnySurface)
{
  // A point is pushed over the opposite edge of one of its triangles, which flips a few.
  const auto folded = [](shape::Mesh mesh)
  {
    const Eigen::RowVector3i t = mesh.Triangles.row(100);
    const Eigen::RowVector3d middle = 0.5 * (mesh.Points.row(t(1)) + mesh.Points.row(t(2)));
    mesh.Points.row(t(0)) += 1.3 * (middle - mesh.Points.row(t(0)));
    return mesh;
  };
  const shape::Mesh plane = Square(10), sphere = shapetest::Icosphere(3);
  for (shape::Mesh mesh : { plane, sphere, shapetest::Torus(1.0, 0.4, 40, 20) })
  {
    const bool isSphere = mesh.Points.rows() == sphere.Points.rows();
    Eigen::MatrixXd images = folded(mesh).Points;
    if (isSphere)
    {
      images.rowwise().normalize();
    }
    const MapQualityResult result = Quality(mesh.Points, images, CellsOf(mesh));
    EXPECT_EQ(result.Flipped(100), 1);
    EXPECT_GE(result.Flipped.sum(), 1);
    EXPECT_LE(result.Flipped.sum(), 3);
    EXPECT_EQ(Quality(mesh.Points, mesh.Points, CellsOf(mesh)).Flipped.sum(), 0);
  }
}

TEST(MapQuality, AHexahedronMappedAffinelyHasTheValuesOfItsTetrahedra)
{
  const Solid cube = RegularSolids().back();
  const int split[5][4] = { { 0, 1, 3, 4 }, { 1, 2, 3, 6 }, { 1, 4, 5, 6 }, { 3, 4, 6, 7 },
    { 1, 3, 4, 6 } };
  CellSimplices tets;
  for (const auto& tet : split)
  {
    tets.Add(CellShape::Tetrahedron, tet);
    tets.EndCell();
  }
  const Eigen::Matrix3d map = Eigen::Matrix3d::Identity() + 0.4 * Rotation(0.3);
  const Eigen::MatrixXd images = cube.Points * map;
  const MapQualityResult hex = Quality(cube.Points, images, OneCell(cube.Shape, 8));
  const MapQualityResult tet = Quality(cube.Points, images, tets);
  ExpectMeasures(tet, hex.Measures.row(0), 10.0);
  EXPECT_NEAR(tet.Sizes.sum(), hex.Sizes(0), 1e-15);
}

TEST(MapQuality, AHexahedronWithOneCornerPushedThroughIsFlippedByItsLeastDeterminant)
{
  const Solid cube = RegularSolids().back();
  Eigen::MatrixXd images = cube.Points;
  images.row(6) << 0.2, 0.2, 0.2;
  const MapQualityResult result = Quality(cube.Points, images, OneCell(cube.Shape, 8));
  EXPECT_EQ(result.Flipped(0), 1);
  // det of the edges from (0.2, 0.2, 0.2) to (1, 1, 0), (1, 0, 1), (0, 1, 1), against 1.
  Eigen::Matrix3d edges;
  edges << 0.8, 0.8, -0.2, 0.8, -0.2, 0.8, -0.2, 0.8, 0.8;
  EXPECT_NEAR(result.Measures(0, 0), -std::abs(edges.determinant()), 1e-14);
}

TEST(MapQuality, MeansDoNotChangeWhenCellsAreSubdivided)
{
  // A map that is affine on each triangle stays so on its quarters.
  shape::Mesh mesh = shapetest::Torus(1.0, 0.4, 12, 9);
  Eigen::MatrixXd images = mesh.Points;
  for (Eigen::Index i = 0; i < images.rows(); ++i)
  {
    images.row(i) *= 1.0 + 0.3 * std::sin(3.0 * mesh.Points(i, 0) + 1.0);
  }
  const MapQualitySums coarse = SumsOf(Quality(mesh.Points, images, CellsOf(mesh)));
  // Only the triangles of one half are split: equal weights for all cells would show.
  shape::Mesh finer{ mesh.Points, Eigen::MatrixXi(0, 3) };
  std::vector<Eigen::RowVector3i> triangles;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i c = mesh.Triangles.row(t);
    if (t % 2 == 0)
    {
      triangles.push_back(c);
      continue;
    }
    const int n = static_cast<int>(finer.Points.rows());
    finer.Points.conservativeResize(n + 1, 3);
    images.conservativeResize(n + 1, 3);
    finer.Points.row(n) =
      (mesh.Points.row(c(0)) + mesh.Points.row(c(1)) + mesh.Points.row(c(2))) / 3;
    images.row(n) = (images.row(c(0)) + images.row(c(1)) + images.row(c(2))) / 3;
    for (int k = 0; k < 3; ++k)
    {
      triangles.push_back({ c(k), c((k + 1) % 3), n });
    }
  }
  finer.Triangles.resize(triangles.size(), 3);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    finer.Triangles.row(t) = triangles[t];
  }
  const MapQualitySums fine = SumsOf(Quality(finer.Points, images, CellsOf(finer)));
  for (int measure = 0; measure < shape::MapMeasureCount; ++measure)
  {
    const auto which = static_cast<MapMeasure>(measure);
    EXPECT_NEAR(fine.Mean(which), coarse.Mean(which), 1e-12) << measure;
    EXPECT_NEAR(fine.Minima(measure), coarse.Minima(measure), 1e-10) << measure;
    EXPECT_NEAR(fine.Maxima(measure), coarse.Maxima(measure), 1e-10) << measure;
  }
  EXPECT_GT(fine.Cells, coarse.Cells);
}

TEST(MapQuality, SumsOfPartsAddUpAndLeaveOutWhatIsNotAsked)
{
  const shape::Mesh mesh = shapetest::Torus(1.0, 0.4, 12, 9);
  Eigen::MatrixXd images = mesh.Points;
  images.col(0) = images.col(0).array().cube();
  const MapQualityResult result = Quality(mesh.Points, images, CellsOf(mesh));
  Eigen::VectorXi half = Eigen::VectorXi::Zero(result.Sizes.size());
  half.head(50).setOnes();
  MapQualitySums parts;
  parts.Add(result, half);
  EXPECT_EQ(parts.Cells, 50.0);
  EXPECT_LT(parts.Weights(0), SumsOf(result).Weights(0));
  parts.Add(result, Eigen::VectorXi::Ones(half.size()) - half);
  EXPECT_NEAR(parts.Mean(MapMeasure::SymmetricDirichlet),
    SumsOf(result).Mean(MapMeasure::SymmetricDirichlet), 1e-9);
  EXPECT_EQ(parts.Minima(0), SumsOf(result).Minima(0));
}

TEST(MapQuality, CellsAndImagesWithoutSizeAreFiniteAndCounted)
{
  const shape::Mesh mesh = Square(2);
  shape::Mesh flat = mesh;
  flat.Points.row(8) = 0.5 * (flat.Points.row(4) + flat.Points.row(5)); // collapses a triangle
  const MapQualityResult source = Quality(flat.Points, mesh.Points, CellsOf(mesh));
  EXPECT_TRUE(source.Measures.allFinite());
  ASSERT_EQ(source.Degenerate.sum(), 1);
  Eigen::Index which = 0;
  source.Degenerate.maxCoeff(&which);
  EXPECT_EQ(source.Sizes(which), 0.0);
  EXPECT_EQ(source.Measures.row(which), Expected(Eigen::Vector2d::Ones()));

  const MapQualityResult image = Quality(mesh.Points, flat.Points, CellsOf(mesh));
  EXPECT_TRUE(image.Measures.allFinite());
  ASSERT_EQ(image.Degenerate(which), 1);
  EXPECT_EQ(image.Measures(which, 0), 0.0);
  EXPECT_EQ(image.Flipped(which), 0);
  EXPECT_EQ(image.Measures(which, 2), LargestMeasure);
  EXPECT_EQ(image.Measures(which, 3), LargestMeasure);
  for (const MapMeasure infinite : { MapMeasure::Hencky, MapMeasure::AMIPS,
         MapMeasure::AreaDistortion, MapMeasure::L2Stretch, MapMeasure::LinfStretch })
  {
    EXPECT_EQ(image.Measures(which, static_cast<int>(infinite)), LargestMeasure);
  }
  EXPECT_EQ(image.Measures(which, static_cast<int>(MapMeasure::SmallestSingularValue)), 0.0);
  const MapQualitySums sums = SumsOf(image);
  EXPECT_EQ(sums.Degenerate, 1.0);
  EXPECT_EQ(sums.Undefined(2), 1.0);
  EXPECT_EQ(sums.Undefined(0), 0.0);
  EXPECT_EQ(sums.Maxima(2), LargestMeasure);
  EXPECT_LT(sums.Mean(MapMeasure::SymmetricDirichlet), 100.0) << "the mean leaves it out";

  // All in one point; solids, too.
  const Solid cube = RegularSolids().back();
  const MapQualityResult point =
    Quality(cube.Points, Eigen::MatrixXd::Zero(8, 3), OneCell(cube.Shape, 8));
  EXPECT_TRUE(point.Measures.allFinite());
  EXPECT_EQ(point.Degenerate(0), 1);
  EXPECT_EQ(point.Measures(0, 0), 0.0);
  EXPECT_NEAR(point.Measures(0, 4), 3.0, 1e-15);
  EXPECT_EQ(SumsOf(point).Mean(MapMeasure::SymmetricDirichlet), LargestMeasure);
}

TEST(MapQuality, AThinImageOverflowsAmipsAloneAndIsNotDegenerate)
{
  const shape::Mesh mesh = Square(2);
  const Eigen::MatrixXd images = mesh.Points * Eigen::RowVector3d(1.0, 1e-4, 1.0).asDiagonal();
  const MapQualityResult result = Quality(mesh.Points, images, CellsOf(mesh));
  EXPECT_EQ(result.Degenerate.sum(), 0);
  EXPECT_EQ(result.Measures(0, static_cast<int>(MapMeasure::AMIPS)), LargestMeasure);
  EXPECT_NEAR(result.Measures(0, static_cast<int>(MapMeasure::LinfStretch)), 1e4, 1e-6);
}

TEST(MapQuality, WithSolidsTheTrianglesAndThePointsAreNotCounted)
{
  const Solid cube = RegularSolids().back();
  CellSimplices cells = OneCell(cube.Shape, 8);
  const int triangle[] = { 0, 1, 2 };
  cells.Add(CellShape::Triangle, triangle);
  cells.EndCell();
  cells.EndCell(); // a point
  const MapQualityResult result = Quality(cube.Points, 2.0 * cube.Points, cells);
  EXPECT_EQ(result.Counted, Eigen::Vector3i(1, 0, 0));
  EXPECT_EQ(SumsOf(result).Cells, 1.0);
  EXPECT_EQ(result.Measures(1, 0), 1.0);
  EXPECT_EQ(result.Measures(0, 0), 8.0);
  EXPECT_EQ(result.Degenerate.sum(), 0);
}

TEST(MapQuality, GivesTheSameBitsTwiceAndCanStop)
{
  const shape::Mesh mesh = shapetest::Torus(1.0, 0.4, 40, 30);
  Eigen::MatrixXd images = mesh.Points;
  images.col(2) = images.col(2).array().sinh();
  const CellSimplices cells = CellsOf(mesh);
  EXPECT_EQ(
    Quality(mesh.Points, images, cells).Measures, Quality(mesh.Points, images, cells).Measures);
  int left = 3;
  EXPECT_THROW(shape::EvaluateMapQuality(mesh.Points, images, cells, {},
                 shape::Progress([&](double) { return --left > 0; })),
    shape::Aborted);
}
