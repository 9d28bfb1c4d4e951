#include "Base/Errors.h"
#include "Distortion/SimplexElements.h"
#include "Parameterize/Parameterize.h"
#include "Quality/MapQuality.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

TEST(Parameterize, OntoTheSphereFlipsNoTriangleAndSaysHow)
{
  shape::Mesh mesh = shapetest::Icosphere(3);
  mesh.Points.col(0) *= 2.0;
  const shape::ParameterizeResult map = shape::Parameterize(mesh);
  const shape::Mesh image{ map.Positions, mesh.Triangles };
  for (Eigen::Index t = 0; t < image.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = image.Points.row(image.Triangles(t, 0));
    const Eigen::RowVector3d b = image.Points.row(image.Triangles(t, 1));
    const Eigen::RowVector3d c = image.Points.row(image.Triangles(t, 2));
    EXPECT_GT(a.dot(b.cross(c)), 0.0);
  }
  EXPECT_LT((map.Positions.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
  EXPECT_EQ(map.Method, "ConformalFlow");
  EXPECT_EQ(map.ReinsertedPoints, 0);
  EXPECT_GT(map.Iterations, 0);
}

TEST(Parameterize, MirrorsNoSurfaceThatFacesInwards)
{
  shape::Mesh mesh = shapetest::Icosphere(3);
  mesh.Points.col(0) *= 2.0;
  mesh.Triangles = mesh.Triangles.rowwise().reverse().eval();
  ASSERT_LT(shape::ComputeEnclosedVolume(mesh), 0.0);
  const shape::ParameterizeResult map = shape::Parameterize(mesh);
  const shape::Mesh image{ map.Positions, mesh.Triangles };
  for (Eigen::Index t = 0; t < image.Triangles.rows(); ++t)
  {
    EXPECT_LT(shape::GetCorners(image, t).determinant(), 0.0);
  }
  EXPECT_LT((map.Positions.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
}

TEST(Parameterize, OfAnEllipsoidIsNearlyConformalWhereRadialProjectionIsNot)
{
  shape::Mesh mesh = shapetest::Icosphere(4);
  mesh.Points.col(0) *= 3.0;
  EXPECT_LT(shape::Parameterize(mesh).ConformalDistortion, 1.02);
}

TEST(Parameterize, AHandleIsRefusedWithTheEulerNumber)
{
  EXPECT_REFUSED(shape::Parameterize(shapetest::Torus(1.0, 0.3, 20, 10)), "Euler number 0");
}

TEST(Parameterize, AreaWeightKeepsTheTriangleOfALimbLarger)
{
  // A sphere with a long arm: the conformal image of the arm's tip is tiny.
  shape::Mesh mesh = shapetest::Icosphere(4);
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const double up = mesh.Points(i, 2);
    mesh.Points(i, 2) += up > 0.9 ? 30.0 * (up - 0.9) : 0.0;
  }
  const auto smallest = [&](double areaWeight)
  {
    shape::ParameterizeOptions options;
    options.AreaWeight = areaWeight;
    const shape::Mesh image{ shape::Parameterize(mesh, options).Positions, mesh.Triangles };
    return shape::ComputeAreaVectors(image).rowwise().norm().minCoeff();
  };
  EXPECT_GT(smallest(1.0), 10.0 * smallest(0.0));
  EXPECT_THROW(smallest(-1.0), shape::InvalidInput);
}

TEST(Parameterize, OntoTheDiskHandsItsOptionsOnAndSaysHow)
{
  // The upper half of an icosphere, without the triangles that reach below its equator.
  shape::Mesh cap = shapetest::Icosphere(3);
  int kept = 0;
  for (Eigen::Index t = 0; t < cap.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = cap.Triangles.row(t);
    if (cap.Points(corners(0), 2) > 0.0 && cap.Points(corners(1), 2) > 0.0 &&
      cap.Points(corners(2), 2) > 0.0)
    {
      cap.Triangles.row(kept++) = corners;
    }
  }
  cap.Triangles.conservativeResize(kept, 3);
  Eigen::VectorXi number = Eigen::VectorXi::Constant(cap.Points.rows(), -1);
  int points = 0;
  for (Eigen::Index i = 0; i < cap.Points.rows(); ++i)
  {
    if ((cap.Triangles.array() == i).any())
    {
      cap.Points.row(points) = cap.Points.row(i);
      number(i) = points++;
    }
  }
  cap.Points.conservativeResize(points, 3);
  cap.Triangles = cap.Triangles.unaryExpr([&](int i) { return number(i); }).eval();

  shape::ParameterizeOptions options;
  options.Domain = shape::ParameterizeOptions::DomainType::Disk;
  const shape::ParameterizeResult map = shape::Parameterize(cap, options);
  EXPECT_EQ(map.Method, "MeanValue");
  EXPECT_EQ(map.FlippedTriangles, 0);
  EXPECT_EQ(map.Iterations, 0);
  EXPECT_GT(map.LoopLength, 6.0);
  EXPECT_LT(map.ConformalDistortion, 1.05);
  EXPECT_EQ(map.Positions, shape::MapToDisk(cap).Points);
  options.Weights = shape::CombinationWeights::Cotangent;
  options.Outline = shape::DiskOutline::Square;
  const shape::ParameterizeResult square = shape::Parameterize(cap, options);
  EXPECT_EQ(square.Method, "Cotangent");
  EXPECT_EQ(square.Positions.leftCols(2).cwiseAbs().maxCoeff(), 1.0);
  EXPECT_EQ(square.Positions,
    shape::MapToDisk(cap, { shape::CombinationWeights::Cotangent, shape::DiskOutline::Square })
      .Points);
}

TEST(Parameterize, FreeBoundaryAndRefineHandTheirOptionsOn)
{
  shape::Mesh bumps = shapetest::FlatDisk(8);
  bumps.Points.col(2) = 0.4 * (3.0 * bumps.Points.col(0)).array().sin();
  shape::ParameterizeOptions options;
  options.Domain = shape::ParameterizeOptions::DomainType::FreeBoundary;
  const shape::ParameterizeResult conformal = shape::Parameterize(bumps, options);
  EXPECT_EQ(conformal.Method, "BoundaryFirst");
  EXPECT_LT(conformal.ConformalDistortion, 1.05);
  options.Refine = shape::RefineType::SymmetricDirichlet;
  const shape::ParameterizeResult refined = shape::Parameterize(bumps, options);
  EXPECT_EQ(refined.Method, "SymmetricDirichlet");
  EXPECT_GT(refined.Iterations, 0);
  EXPECT_LE(refined.Energy, conformal.Energy);
  EXPECT_GE(refined.Energy, 4.0);
  options.Domain = shape::ParameterizeOptions::DomainType::Disk;
  const shape::ParameterizeResult disk = shape::Parameterize(bumps, options);
  EXPECT_GT(disk.Energy, refined.Energy);
  EXPECT_NEAR(disk.Positions.rowwise().norm().maxCoeff(), 1.0, 1e-15);
}

TEST(Parameterize, RefineLowersEachMeasureAndMapQualityMeasuresTheSame)
{
  using Refine = shape::RefineType;
  using shape::MapMeasure;
  shape::Mesh bumps = shapetest::FlatDisk(8);
  bumps.Points.col(2) = 0.4 * (3.0 * bumps.Points.col(0)).array().sin();
  shape::CellSimplices cells;
  for (const auto& triangle : bumps.Triangles.rowwise())
  {
    const Eigen::RowVector3i corners = triangle;
    cells.Add(shape::CellShape::Triangle, corners.data());
    cells.EndCell();
  }
  struct Case
  {
    Refine Type;
    const char* Name;
    MapMeasure Same;
    double Factor; // of the measure of Refine, relative to that of MapQuality
  };
  for (const Case& one :
    { Case{ Refine::SymmetricDirichlet, "SymmetricDirichlet", MapMeasure::SymmetricDirichlet, 1.0 },
      Case{ Refine::AMIPS, "AMIPS", MapMeasure::AMIPS, 1.0 },
      Case{ Refine::ConformalAMIPS, "ConformalAMIPS", MapMeasure::ConformalDistortion, 2.0 },
      Case{ Refine::Hencky, "Hencky", MapMeasure::Hencky, 1.0 },
      Case{ Refine::ARAP, "ARAP", MapMeasure::ARAP, 1.0 } })
  {
    shape::ParameterizeOptions options;
    options.Domain = shape::ParameterizeOptions::DomainType::FreeBoundary;
    options.Refine = one.Type;
    const shape::ParameterizeResult map = shape::Parameterize(bumps, options);
    EXPECT_EQ(map.Method, one.Name);
    EXPECT_EQ(map.FlippedTriangles, 0);
    EXPECT_LT(map.MeasureAfter, map.MeasureBefore) << one.Name;
    const shape::MapQualityResult quality = shape::EvaluateMapQuality(bumps.Points, map.Positions,
      cells, shape::ComputeMapExtent(bumps.Points, map.Positions, cells));
    shape::MapQualitySums sums;
    sums.Add(quality, Eigen::VectorXi::Ones(bumps.Triangles.rows()));
    EXPECT_NEAR(map.MeasureAfter / (one.Factor * sums.Mean(one.Same)), 1.0, 1e-9) << one.Name;
  }
}

TEST(Parameterize, ALargerRefineExponentLowersTheWorstTriangle)
{
  shape::Mesh bumps = shapetest::FlatDisk(8);
  bumps.Points.col(2) = 0.4 * (3.0 * bumps.Points.col(0)).array().sin();
  shape::ParameterizeOptions options;
  options.Domain = shape::ParameterizeOptions::DomainType::FreeBoundary;
  options.Refine = shape::RefineType::ExponentialSymmetricDirichlet;
  double worst = 1e30;
  for (const double exponent : { 0.1, 1.0, 10.0 })
  {
    options.RefineExponent = exponent;
    const shape::ParameterizeResult map = shape::Parameterize(bumps, options);
    const shape::SimplexElements<2> elements = shape::BuildTriangleElements(bumps, 1.0);
    double least = 0.0;
    for (Eigen::Index t = 0; t < bumps.Triangles.rows(); ++t)
    {
      const Eigen::Vector2d s =
        shape::DecomposePositive(elements.Jacobian(static_cast<int>(t), map.Positions.leftCols(2)))
          .Singular;
      least = std::max(least, s.squaredNorm() + s.cwiseInverse().squaredNorm());
    }
    EXPECT_LT(least, worst) << "exponent " << exponent;
    worst = least;
  }
  options.RefineExponent = 0.0;
  EXPECT_THROW(shape::Parameterize(bumps, options), shape::InvalidInput);
}

TEST(Parameterize, OntoTheOrbifoldTakesTheNearestPointsAsCones)
{
  const shape::Mesh mesh = shapetest::Icosphere(3);
  const Eigen::MatrixXd landmarks = 1.5 * mesh.Points.topRows(4);
  shape::ParameterizeOptions options;
  options.Domain = shape::ParameterizeOptions::DomainType::Orbifold;
  const shape::ParameterizeResult map = shape::Parameterize(mesh, landmarks, options);
  EXPECT_EQ(map.Method, "Parallelogram");
  EXPECT_EQ(map.Positions, map.CutPositions.topRows(642));
  EXPECT_GT(map.CutPositions.rows(), 642);
  EXPECT_LT(map.ConformalDistortion, 1.1);
  options.Tile = shape::OrbifoldType::Square;
  const shape::ParameterizeResult square = shape::Parameterize(mesh, landmarks.topRows(3), options);
  EXPECT_EQ(square.Method, "Square");
  EXPECT_LT((square.Positions.row(2) - Eigen::RowVector3d(1.0, 1.0, 0.0)).norm(), 1e-15);
  EXPECT_THROW(shape::Parameterize(mesh, options), shape::InvalidInput);
  options.Domain = shape::ParameterizeOptions::DomainType::Sphere;
  EXPECT_THROW(shape::Parameterize(mesh, landmarks, options), shape::InvalidInput);
}
