#include "Base/Errors.h"
#include "Harmonic/ApplyVolumeMap.h"
#include "Harmonic/FiniteElementMap.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/VolumeMap.h"
#include "Mesh/UsedPoints.h"
#include "Search/ClosestPoint.h"
#include "Support/HarmonicShapes.h"
#include "Support/ProgressChecks.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using shape::ComputeFiniteElements;
using shape::FiniteElementMap;
using shape::FiniteElements;
using shape::Mesh;
using Method = shape::HarmonicVolumeMapOptions::MethodType;

/// Harmonic in all coordinates, and one-to-one in the unit ball.
Eigen::MatrixXd Field(const Eigen::MatrixXd& at)
{
  Eigen::MatrixXd values = at;
  const Eigen::ArrayXd x = at.col(0), y = at.col(1), z = at.col(2);
  values.col(0).array() += 0.2 * (y * y - z * z);
  values.col(1).array() += 0.2 * x * z;
  values.col(2).array() += 0.1 * (x * x * x - 3.0 * x * y * y);
  return values;
}

/// Positions in the ball of the given radius.
Eigen::MatrixXd Inside(double radius, int count)
{
  Eigen::MatrixXd points(count, 3);
  for (int i = 0; i < count; ++i)
  {
    // A spiral of equal areas on spheres of all sizes.
    const double z = 1.0 - (2.0 * i + 1.0) / count, angle = 2.399963 * i;
    const double r = radius * std::cbrt(std::fmod(0.618034 * i, 1.0)),
                 flat = std::sqrt(1.0 - z * z);
    points.row(i) << r * flat * std::cos(angle), r * flat * std::sin(angle), r * z;
  }
  return points;
}

double RootMeanSquare(const Eigen::MatrixXd& errors)
{
  return std::sqrt(errors.squaredNorm() / static_cast<double>(errors.rows()));
}

shape::VolumeMapConditions Conditions()
{
  shape::VolumeMapConditions conditions;
  const Mesh ball = shapetest::Icosphere(2);
  conditions.Boundary = ball;
  conditions.Targets = Field(ball.Points);
  return conditions;
}

shape::VolumeMapOptions ByElements()
{
  shape::VolumeMapOptions options;
  options.Harmonic.Method = Method::FiniteElements;
  options.Harmonic.Tetrahedra = 3000;
  return options;
}

} // namespace

TEST(FiniteElementMap, ReproducesAffineMapsAlsoBesideVoids)
{
  Mesh shell = shapetest::Icosphere(2), cavity = shapetest::Icosphere(2);
  cavity.Points *= 0.4; // faces the wrong way, which does not matter
  shell = shape::JoinMeshes({ shell, cavity });
  shell.Points.rowwise() += Eigen::RowVector3d(100, -20, 5);
  Eigen::Matrix3d matrix;
  matrix << 2, 0.3, 0, -0.5, 1, 0.2, 0, 0.1, 3;
  const auto affine = [&](const Eigen::MatrixXd& at)
  { return Eigen::MatrixXd((at * matrix.transpose()).rowwise() + Eigen::RowVector3d(7, 8, 9)); };
  const FiniteElements elements = ComputeFiniteElements(shell, affine(shell.Points), 5000);
  EXPECT_LT((elements.Images - affine(elements.Points)).cwiseAbs().maxCoeff(), 1e-10);
  EXPECT_GT(elements.FreePoints, 500);

  const FiniteElementMap map(elements);
  const Eigen::MatrixXd jacobians = map.Jacobians(Eigen::VectorXi::LinSpaced(50, 0, 49));
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = matrix;
  const Eigen::RowVectorXd expected = Eigen::Map<const Eigen::RowVectorXd>(rows.data(), 9);
  EXPECT_LT((jacobians.rowwise() - expected).cwiseAbs().maxCoeff(), 1e-9);

  // The void is outside, and so is what lies beyond the sphere.
  Eigen::MatrixXd points(3, 3);
  points << 100, -20, 5, 100.7, -20, 5, 102, -20, 5;
  const shape::MovedPoints moved = shape::ApplyVolumeMap(map, points);
  EXPECT_EQ(moved.OutsideDomain, Eigen::Vector3i(1, 0, 1));
  EXPECT_EQ(moved.Points.row(0), points.row(0));
  EXPECT_LT((moved.Points.row(1) - affine(points).row(1)).norm(), 1e-10);
}

TEST(FiniteElementMap, IsLinearInTheTrianglesOfTheBoundary)
{
  const Mesh dented = shapetest::DentedSphere(2);
  const Eigen::MatrixXd values = Field(dented.Points);
  const FiniteElements elements = ComputeFiniteElements(dented, values, 50000);
  const FiniteElementMap map(elements);
  EXPECT_GT(elements.Boundary.rows(), 2 * dented.Triangles.rows()) << "points are added on it";
  EXPECT_LT((map.Evaluate(dented.Points).Images - values).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::MatrixXd at = shape::SampleRandomly(dented, 1000, 1);
  const shape::ClosestPoints closest = shape::SurfaceLocator(dented).Find(at);
  EXPECT_LT(
    (map.Evaluate(at).Images - PullBack(closest, dented.Triangles, values)).cwiseAbs().maxCoeff(),
    1e-8);
  // The triangles of the boundary enclose the volume of the solid.
  EXPECT_NEAR(shape::ComputeEnclosedVolume(Mesh{ elements.Points, elements.Boundary }),
    shape::ComputeEnclosedVolume(dented), 1e-10);
}

TEST(FiniteElementMap, MinimizesTheDirichletEnergy)
{
  const Mesh ball = shapetest::Icosphere(2);
  const FiniteElements elements = ComputeFiniteElements(ball, Field(ball.Points), 3000);
  const FiniteElementMap map(elements);
  const auto energy = [](const FiniteElements& some)
  {
    const Eigen::VectorXi all = Eigen::VectorXi::LinSpaced(
      some.Tetrahedra.rows(), 0, static_cast<int>(some.Tetrahedra.rows()) - 1);
    const Eigen::MatrixXd jacobians = FiniteElementMap(some).Jacobians(all);
    double sum = 0.0;
    for (Eigen::Index t = 0; t < jacobians.rows(); ++t)
    {
      Eigen::Matrix3d edges;
      for (int k = 0; k < 3; ++k)
      {
        edges.row(k) =
          some.Points.row(some.Tetrahedra(t, k + 1)) - some.Points.row(some.Tetrahedra(t, 0));
      }
      sum += edges.determinant() / 6.0 * jacobians.row(t).squaredNorm();
    }
    return sum;
  };
  const double least = energy(elements);
  std::vector<char> isFree(elements.Points.rows(), 1);
  for (const int point : elements.Boundary.reshaped())
  {
    isFree[point] = 0;
  }
  // The energy is quadratic: up and down by the same, if its derivative is zero.
  int tried = 0;
  for (int i = 0; i < elements.Points.rows() && tried < 20; i += 7)
  {
    if (!isFree[i])
    {
      continue;
    }
    FiniteElements up = elements, down = elements;
    up.Images(i, tried % 3) += 0.01;
    down.Images(i, tried % 3) -= 0.01;
    const double above = energy(up) - least, below = energy(down) - least;
    EXPECT_GT(above, 0.0);
    EXPECT_NEAR(above, below, 1e-6 * above);
    ++tried;
  }
  EXPECT_EQ(tried, 20);
}

// The difference from the field, and from the map of charges, falls with the square of the size.
TEST(FiniteElementMap, ConvergesToTheMapOfFundamentalSolutions)
{
  std::vector<double> errors, differences;
  const Eigen::MatrixXd points = Inside(0.9, 2000);
  for (const int level : { 2, 3, 4 })
  {
    // Triangles of half the size, and tetrahedra of half the size.
    const Mesh ball = shapetest::Icosphere(level);
    const Eigen::MatrixXd values = Field(ball.Points);
    const FiniteElementMap map(ComputeFiniteElements(ball, values, 2000 << (3 * (level - 2))));
    const Eigen::MatrixXd images = map.Evaluate(points).Images;
    errors.push_back(RootMeanSquare(images - Field(points)));
    shape::HarmonicVolumeMapOptions options;
    options.Tolerance = 1e-5;
    const auto charges = shape::ComputeHarmonicVolumeMap(ball, values, {}, options);
    differences.push_back(RootMeanSquare(images - shape::Evaluate(charges.Map, points)));
  }
  for (int i = 0; i < 2; ++i)
  {
    EXPECT_GT(errors[i], 3.0 * errors[i + 1]) << i; // 4 for the second order
    EXPECT_GT(differences[i], 3.0 * differences[i + 1]) << i;
  }
  EXPECT_LT(differences[2], 1e-3);
  RecordProperty("finest", std::to_string(differences[2]));
}

TEST(FiniteElementMap, DoesNotDependOnTheNumbering)
{
  const Mesh dented = shapetest::DentedSphere(2);
  const Eigen::Index count = dented.Points.rows(), triangles = dented.Triangles.rows();
  const Mesh reversed{ dented.Points.colwise().reverse(),
    (count - 1 - dented.Triangles.array()).matrix().colwise().reverse() };
  const FiniteElements one = ComputeFiniteElements(dented, Field(dented.Points), 3000);
  const FiniteElements other = ComputeFiniteElements(reversed, Field(reversed.Points), 3000);
  ASSERT_EQ(reversed.Triangles.rows(), triangles);
  EXPECT_EQ(one.Points, other.Points) << "bit by bit";
  EXPECT_EQ(one.Tetrahedra, other.Tetrahedra);
  EXPECT_EQ(one.Images, other.Images);
}

TEST(FiniteElementMap, IsInvertedByExchangingPointsAndImages)
{
  const Mesh ball = shapetest::Icosphere(3);
  const FiniteElementMap map(ComputeFiniteElements(ball, Field(ball.Points), 20000));
  const FiniteElementMap inverse = map.Inverse();
  const Eigen::MatrixXd points = Inside(0.95, 1000);
  const shape::MovedPoints there = shape::ApplyVolumeMap(map, points);
  const shape::MovedPoints back = shape::ApplyVolumeMap(inverse, there.Points);
  EXPECT_EQ(there.OutsideDomain.sum(), 0);
  EXPECT_EQ(back.OutsideDomain.sum(), 0);
  EXPECT_LT((back.Points - points).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(FiniteElementMap, IsAMethodOfTheVolumeMap)
{
  const shape::VolumeMapResult result = shape::ComputeVolumeMap(Conditions(), ByElements());
  ASSERT_TRUE(result.Elements);
  const FiniteElements own =
    ComputeFiniteElements(Conditions().Boundary, Conditions().Targets, 3000);
  EXPECT_EQ(result.Elements->Images, own.Images) << "bit by bit";
  EXPECT_EQ(result.Map.Charges.Maps.front().Points.rows(), 0);
  EXPECT_LT(result.Map.Borders.front().Maximum, 1e-8);
  EXPECT_EQ(result.Map.Layers.front().Levels.back().Sources, own.FreePoints);
}

TEST(FiniteElementMap, RefusesWhatItCannotMeet)
{
  const auto refusal =
    [](const shape::VolumeMapConditions& conditions, const shape::VolumeMapOptions& options)
  { return shapetest::Refusal([&] { shape::ComputeVolumeMap(conditions, options); }); };
  shape::VolumeMapConditions conditions = Conditions();
  shape::VolumeMapOptions options = ByElements();
  options.Exact = true;
  EXPECT_NE(refusal(conditions, options).find("Exact"), std::string::npos);
  options = ByElements();
  options.FreeBoundary = true;
  conditions.Target = Mesh{ conditions.Targets, conditions.Boundary.Triangles() };
  EXPECT_NE(refusal(conditions, options).find("free the boundary"), std::string::npos);
  options = ByElements();
  options.Harmonic.Tetrahedra = 10;
  EXPECT_NE(refusal(conditions, options).find("Tetrahedra is 10"), std::string::npos);
  options = ByElements();
  conditions.Features.Points = conditions.Features.Targets = Eigen::MatrixXd::Zero(1, 3);
  EXPECT_NE(refusal(conditions, options).find("Features"), std::string::npos);
  EXPECT_THROW(
    shape::ComputeHarmonicVolumeMap(conditions.Boundary, conditions.Targets, {}, options.Harmonic),
    shape::InvalidInput);
  EXPECT_THROW(FiniteElementMap(FiniteElements{}), shape::InvalidInput);
}

TEST(FiniteElementMap, ReportsProgressAndStops)
{
  const Mesh ball = shapetest::Icosphere(2);
  const auto compute = [&](const shape::Progress& progress)
  { ComputeFiniteElements(ball, Field(ball.Points), 3000, progress); };
  EXPECT_GT(shapetest::ExpectProgressRises(compute), 5);
  shapetest::ExpectStopsAt(4, compute);
}
