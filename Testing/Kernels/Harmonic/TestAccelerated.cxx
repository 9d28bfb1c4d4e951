#include "Base/Errors.h"
#include "Distance/SignedDistance.h"
#include "Fmm/DirectSummation.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/NearSurfaceCharges.h"
#include "Linear/Gmres.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Remesh/LongestEdgeBisection.h"
#include "Support/HarmonicShapes.h"
#include "Support/TestShapes.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{

shape::HarmonicVolumeMapOptions Accelerated()
{
  shape::HarmonicVolumeMapOptions options;
  options.Method = shape::HarmonicVolumeMapOptions::MethodType::Accelerated;
  return options;
}

/// An ellipsoid that is wider on one side.
shape::Mesh Egg(int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  for (auto p : mesh.Points.rowwise())
  {
    p(1) *= 0.7 + 0.1 * p(0);
    p(2) *= 0.6;
  }
  return mesh;
}

/// Two coordinates of charges outside the egg, and the third as it is.
Eigen::MatrixXd HarmonicInEgg(const Eigen::MatrixXd& points)
{
  Eigen::MatrixXd positions(2, 3), charges(2, 3);
  positions << 1.6, 0.8, 0.3, -0.5, -1.4, 1.1;
  charges << 4.0, -1.0, 0.0, 1.0, 3.0, 0.0;
  return points + shape::SumPotentialsDirectly(positions, charges, points);
}

double ErrorInEgg(const shape::ChargeSet& map, const shape::Mesh& boundary)
{
  Eigen::MatrixXd inside(3 * boundary.Points.rows(), 3);
  inside << 0.9 * boundary.Points, 0.5 * boundary.Points, 0.1 * boundary.Points;
  return std::sqrt((shape::Evaluate(map, inside) - HarmonicInEgg(inside)).squaredNorm() /
           static_cast<double>(inside.rows())) /
    shape::ComputeLongestBoxEdge(HarmonicInEgg(boundary.Points));
}

} // namespace

TEST(Gmres, SolvesASquareSystemInAsManyStepsAsItHasRows)
{
  std::srand(3);
  constexpr int n = 12;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(n, n) + 3.0 * Eigen::MatrixXd::Identity(n, n);
  const Eigen::MatrixXd x = Eigen::MatrixXd::Random(n, 3), b = a * x;
  shape::GmresOptions options;
  options.MaximumIterations = n;
  options.Tolerance = 0.0;
  const auto result =
    shape::SolveGmres([&](const Eigen::MatrixXd& v, const shape::Progress&) { return a * v; },
      [](const Eigen::MatrixXd& v, const shape::Progress&) { return v; }, b,
      Eigen::VectorXd::Ones(n), options);
  EXPECT_LT((result.Solution - x).norm(), 1e-10 * x.norm());
  EXPECT_LT(result.Residuals.maxCoeff(), 1e-12);
}

TEST(Gmres, FindsTheWeightedLeastSquares)
{
  std::srand(4);
  constexpr int m = 20, n = 6;
  const Eigen::MatrixXd a = Eigen::MatrixXd::Random(m, n), b = Eigen::MatrixXd::Random(m, 2);
  const Eigen::VectorXd weights = Eigen::VectorXd::Random(m).array() + 1.5;
  const Eigen::MatrixXd back = a.transpose() * weights.asDiagonal();
  shape::GmresOptions options;
  options.Tolerance = 0.0;
  const auto result =
    shape::SolveGmres([&](const Eigen::MatrixXd& v, const shape::Progress&) { return a * v; },
      [&](const Eigen::MatrixXd& v, const shape::Progress&) { return back * v; }, b, weights,
      options);
  const Eigen::MatrixXd expected = (back * a).ldlt().solve(back * b);
  EXPECT_LT((result.Solution - expected).norm(), 1e-9 * expected.norm());
  for (int c = 0; c < 2; ++c)
  {
    const Eigen::VectorXd left = b.col(c) - a * expected.col(c);
    EXPECT_NEAR(
      result.Residuals(c), std::sqrt(left.cwiseAbs2().dot(weights) / weights.sum()), 1e-10);
    EXPECT_LT((result.Left.col(c) - left).norm(), 1e-9 * left.norm());
  }
}

TEST(Gmres, TheErrorOfTheOperatorMayGrowAsTheResidualFalls)
{
  // Errors e_k of the operator, in products with unit vectors, add sum_k |y_k| e_k to the residual,
  // with the coefficients y of the solution. |y_k| is at most the residual before step k, divided
  // by the least singular value (Simoncini and Szyld 2003, section 5).
  std::srand(5);
  constexpr int n = 40;
  constexpr double error = 1e-12;
  const Eigen::MatrixXd a =
    Eigen::MatrixXd::Random(n, n) / 6.0 + Eigen::MatrixXd::Identity(n, n) * 3.0;
  const Eigen::VectorXd b = Eigen::VectorXd::Random(n).normalized() * std::sqrt(double(n));
  shape::GmresOptions options;
  options.Tolerance = 1e-9;
  double share = 0.0;
  options.Relax = [&](double left) { share = left; };
  const auto result = shape::SolveGmres(
    [&](const Eigen::MatrixXd& v, const shape::Progress&)
    {
      const Eigen::VectorXd noise = Eigen::VectorXd::Random(n).normalized();
      return Eigen::MatrixXd(a * v + noise * (error / share * v.norm()));
    },
    [](const Eigen::MatrixXd& v, const shape::Progress&) { return v; }, b, Eigen::VectorXd::Ones(n),
    options);
  EXPECT_LT(share, 1e-7); // the last error was above 1e-5
  const double least = a.jacobiSvd().singularValues()(n - 1);
  const double missing = (a * result.Solution - b).norm() / b.norm();
  EXPECT_LT(missing, result.Residuals(0) + result.Iterations * error / least);
}

TEST(LongestEdgeBisection, KeepsTheSurfaceAndItsTopology)
{
  shape::Mesh mesh = shapetest::Torus(1.0, 0.3, 24, 5); // slim triangles
  const double volume = shape::ComputeEnclosedVolume(mesh),
               area = shape::ComputePointAreas(mesh).sum();
  const auto before = mesh.Triangles.rows();
  const auto sharpest = [](const shape::Mesh& surface)
  {
    double minimum = M_PI;
    for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
    {
      const Eigen::Matrix3d p = shape::GetCorners(surface, t);
      for (int k = 0; k < 3; ++k)
      {
        const Eigen::RowVector3d one = p.row((k + 1) % 3) - p.row(k);
        const Eigen::RowVector3d other = p.row((k + 2) % 3) - p.row(k);
        minimum = std::min(minimum, std::acos(one.dot(other) / (one.norm() * other.norm())));
      }
    }
    return minimum;
  };
  const double angle = sharpest(mesh);
  std::vector<char> marked(before, 0);
  marked[3] = marked[40] = marked[41] = 1;
  const Eigen::MatrixXi ends = shape::BisectLongestEdges(mesh, marked);
  ASSERT_GE(ends.rows(), 7); // three edges each, one of which two share
  EXPECT_EQ(mesh.Triangles.rows(), before + 2 * ends.rows());
  EXPECT_EQ(shape::RequireClosedSurface(mesh, "the torus").EulerNumber, 0);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(mesh), volume, 1e-12);
  EXPECT_NEAR(shape::ComputePointAreas(mesh).sum(), area, 1e-12);
  for (Eigen::Index k = 0; k < ends.rows(); ++k)
  {
    const Eigen::RowVector3d middle =
      0.5 * (mesh.Points.row(ends(k, 0)) + mesh.Points.row(ends(k, 1)));
    EXPECT_EQ(mesh.Points.row(mesh.Points.rows() - ends.rows() + k), middle);
  }
  for (int round = 0; round < 4; ++round)
  {
    shape::BisectLongestEdges(mesh, std::vector<char>(mesh.Triangles.rows(), 1));
  }
  // However often: Rivara's bound (Rosenberg and Stenger, 1975).
  EXPECT_GE(sharpest(mesh), 0.5 * angle);
}

TEST(NearSurfaceCharges, KeepTheirDistanceInAGap)
{
  // A sphere with a void of 0.96 of its size around its middle: the gap is the solid; outside and
  // in the void there is room. Turned inside out the gap is where the charges go.
  shape::Mesh sphere = shapetest::Icosphere(3);
  shape::Mesh shells = sphere;
  const Eigen::Index n = sphere.Points.rows();
  shells.Points.conservativeResize(2 * n, 3);
  shells.Points.bottomRows(n) = 1.04 * sphere.Points;
  shells.Triangles.conservativeResize(2 * sphere.Triangles.rows(), 3);
  // The inner one bounds solid, the outer one the gap around it.
  shells.Triangles.bottomRows(sphere.Triangles.rows()) =
    (sphere.Triangles.array() + static_cast<int>(n)).rowwise().reverse();
  const shape::SignedDistance field(shells);
  const Eigen::VectorXd offsets = Eigen::VectorXd::Constant(n, 0.1);
  const auto sources =
    shape::InsertNearSurfaceCharges(field, sphere.Points, sphere.Points, offsets);
  ASSERT_EQ(sources.Sites.size(), n);
  EXPECT_LT(sources.Offsets.maxCoeff(), 0.04);
  const Eigen::VectorXd distances = field.Evaluate(sources.Points).Distances;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    EXPECT_GE(distances(i), 0.6 * sources.Offsets(i));
    EXPECT_NEAR(sources.Points.row(i).norm(), 1.0 + sources.Offsets(i), 1e-12);
    EXPECT_GT(sources.Offsets(i), 0.01); // no nearer than it takes
  }
  // Where that would be too near, there is none.
  EXPECT_EQ(shape::InsertNearSurfaceCharges(field, sphere.Points, sphere.Points, 2.0 * offsets)
              .Sites.size(),
    0);
}

TEST(Accelerated, TheInteriorErrorIsOfSecondOrderInTheEdges)
{
  double errors[3];
  for (int level = 2; level < 5; ++level)
  {
    const shape::Mesh boundary = Egg(level);
    const auto result =
      shape::ComputeHarmonicVolumeMap(boundary, HarmonicInEgg(boundary.Points), {}, Accelerated());
    errors[level - 2] = ErrorInEgg(result.Map, boundary);
  }
  EXPECT_GT(errors[0] / errors[1], 3.0) << errors[0];
  EXPECT_GT(errors[1] / errors[2], 3.0) << errors[1];
  EXPECT_LT(errors[2], 1e-4);
}

TEST(Accelerated, AffineMapsAreExact)
{
  shapetest::ExpectAffineMapIsExact(Egg(3), Accelerated());
}

TEST(Accelerated, RefinesWhereTheBoundaryMapBendsSharply)
{
  // All is well but for one point that goes elsewhere.
  const shape::Mesh boundary = Egg(3);
  Eigen::MatrixXd targets = boundary.Points;
  targets(100, 2) += 0.05;
  auto options = Accelerated();
  options.MaximumLevels = 1;
  const auto coarse = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
  options.MaximumLevels = 4;
  const auto fine = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
  ASSERT_GT(fine.Levels.size(), coarse.Levels.size());
  EXPECT_LT(fine.Levels.back().RMSEInside, 0.5 * coarse.Levels.back().RMSEInside);
  EXPECT_LT(fine.Levels.back().Sources, 1.5 * static_cast<double>(boundary.Points.rows()));
  EXPECT_EQ(coarse.RefinedPoints, 0);
  EXPECT_EQ(fine.RefinedPoints, fine.Levels.back().Sources - coarse.Levels.back().Sources);
  EXPECT_GT(fine.Iterations, coarse.Iterations);
}

TEST(Accelerated, PointsAtGapsTooNarrowForChargesAreCounted)
{
  // A ball, and one with a slit.
  const shape::Mesh ball = shapetest::Icosphere(3);
  const Eigen::Index n = ball.Points.rows(), m = ball.Triangles.rows();
  shape::Mesh slit{ Eigen::MatrixXd(2 * n, 3), Eigen::MatrixXi(2 * m, 3) };
  slit.Points << ball.Points, ball.Points * Eigen::Vector3d(0.5, 0.5, 1e-4).asDiagonal();
  slit.Triangles << ball.Triangles,
    (ball.Triangles.array() + static_cast<int>(n)).rowwise().reverse();
  auto options = Accelerated();
  options.MaximumLevels = 1;
  const auto without =
    shape::ComputeHarmonicVolumeMap(ball, HarmonicInEgg(ball.Points), {}, options);
  const auto with = shape::ComputeHarmonicVolumeMap(slit, HarmonicInEgg(slit.Points), {}, options);
  EXPECT_EQ(without.PointsWithoutCharge, 0);
  EXPECT_EQ(with.PointsWithoutCharge, n);
  EXPECT_EQ(with.Levels.back().Sources, without.Levels.back().Sources);
}

TEST(Accelerated, TheSetupServesOtherTargets)
{
  const shape::Mesh boundary = Egg(3), other = Egg(2);
  const Eigen::MatrixXd first = HarmonicInEgg(boundary.Points);
  Eigen::MatrixXd second = first;
  second.col(0) += 0.3 * first.col(1);
  shape::AcceleratedSetup setup;
  const auto solve = [&](const shape::Mesh& mesh, const Eigen::MatrixXd& targets)
  { return shape::ComputeHarmonicVolumeMap(mesh, targets, {}, Accelerated(), {}, &setup).Map; };
  solve(boundary, first);
  const shape::NearSurfaceChargeSystem* kept = setup.System.get();
  const shape::ChargeSet again = solve(boundary, second);
  EXPECT_EQ(setup.System.get(), kept);
  const auto fresh = shape::ComputeHarmonicVolumeMap(boundary, second, {}, Accelerated()).Map;
  EXPECT_EQ(again.Points, fresh.Points);
  EXPECT_EQ(again.Charges, fresh.Charges);
  // Another boundary is not taken for the first.
  const shape::ChargeSet smaller = solve(other, HarmonicInEgg(other.Points));
  EXPECT_LT(ErrorInEgg(smaller, other), 1e-2);
}

TEST(Accelerated, TheNumberOfThreadsHardlyMatters)
{
  const shape::Mesh boundary = Egg(4);
  const Eigen::MatrixXd targets = HarmonicInEgg(boundary.Points);
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  const auto one = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, Accelerated()).Map;
  setenv("VTK_SMP_MAX_THREADS", "3", 1);
  const auto three = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, Accelerated()).Map;
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_LT(
    (shape::Evaluate(one, 0.9 * boundary.Points) - shape::Evaluate(three, 0.9 * boundary.Points))
      .cwiseAbs()
      .maxCoeff(),
    1e-9 * shape::ComputeLongestBoxEdge(targets));
}

TEST(Accelerated, ThinWallsAndVoidsAreMet)
{
  // A shell a tenth as thick as it is wide: data that differ on its two sides.
  shape::Mesh outer = shapetest::Icosphere(3), shell = outer;
  const Eigen::Index n = outer.Points.rows();
  shell.Points.conservativeResize(2 * n, 3);
  shell.Points.bottomRows(n) = 0.8 * outer.Points;
  shell.Triangles.conservativeResize(2 * outer.Triangles.rows(), 3);
  shell.Triangles.bottomRows(outer.Triangles.rows()) =
    (outer.Triangles.array() + static_cast<int>(n)).rowwise().reverse();
  // f = y + 0.2 y (1 / |y|^3 - 1): y on the unit sphere, harmonic, and not affine.
  const auto exact = [](const Eigen::MatrixXd& points)
  {
    Eigen::MatrixXd values = points;
    for (auto p : values.rowwise())
    {
      p *= 0.8 + 0.2 / std::pow(p.norm(), 3.0);
    }
    return values;
  };
  const auto result =
    shape::ComputeHarmonicVolumeMap(shell, exact(shell.Points), {}, Accelerated());
  const Eigen::MatrixXd between = 0.9 * outer.Points;
  const double error =
    (shape::Evaluate(result.Map, between) - exact(between)).rowwise().norm().maxCoeff();
  EXPECT_LT(error, 5e-3); // the facets' own: h^2 / 8 of an edge of 0.14 is 2.5e-3
}
