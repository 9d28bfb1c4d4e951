#include "Base/Errors.h"
#include "Geodesics/GeodesicDistance.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace
{

using shapetest::ReadModel;

using Method = shape::GeodesicDistanceOptions::MethodType;

Eigen::VectorXd Distances(const shape::Mesh& mesh, const Eigen::MatrixXd& seeds, Method method)
{
  shape::GeodesicDistanceOptions options;
  options.Method = method;
  return shape::ComputeGeodesicDistance(mesh, seeds, options).Distances;
}

/// The angles to the seed: great circles of the unit sphere.
Eigen::VectorXd Angles(const shape::Mesh& sphere, const Eigen::RowVector3d& seed)
{
  return (sphere.Points * seed.normalized().transpose()).array().min(1.0).max(-1.0).acos().matrix();
}

double LargestError(int level, Method method)
{
  const shape::Mesh sphere = shapetest::Icosphere(level);
  const Eigen::RowVector3d seed = sphere.Points.row(3);
  return (Distances(sphere, seed, method) - Angles(sphere, seed)).cwiseAbs().maxCoeff();
}

} // namespace

TEST(GeodesicDistance, OnASphereTendsToGreatCircles)
{
  // Polyhedra in the sphere: paths are too short by the square of the edge.
  EXPECT_LT(LargestError(4, Method::Exact), 0.3 * LargestError(3, Method::Exact));
  EXPECT_LT(LargestError(4, Method::Exact), 3e-3);
  // Heat: by the edge.
  EXPECT_LT(LargestError(5, Method::Heat), 0.7 * LargestError(4, Method::Heat));
  EXPECT_LT(LargestError(5, Method::Heat), 0.03);
}

TEST(GeodesicDistance, MethodsAgreeOnRealSurfaces)
{
  for (const char* name : { "elephant", "hand", "elk" })
  {
    SCOPED_TRACE(name);
    const shape::Mesh mesh = ReadModel(name);
    const Eigen::RowVector3d seed = mesh.Points.row(11);
    const Eigen::VectorXd exact = Distances(mesh, seed, Method::Exact),
                          edges = Distances(mesh, seed, Method::Dijkstra),
                          heat = Distances(mesh, seed, Method::Heat);
    const double size = exact.maxCoeff();
    // Paths along edges are paths on the surface.
    EXPECT_GT((edges - exact).minCoeff(), -1e-12 * size);
    EXPECT_LT((edges - exact).maxCoeff(), 0.25 * size);
    EXPECT_LT((heat - exact).cwiseAbs().mean(), 0.02 * size);
    EXPECT_EQ(exact(11), 0.0);
    EXPECT_EQ(edges(11), 0.0);
  }
}

TEST(GeodesicDistance, IsThatToTheNearestSeed)
{
  const shape::Mesh mesh = ReadModel("elephant");
  const Eigen::RowVector3d one = mesh.Points.row(5), other = mesh.Points.row(2000);
  Eigen::MatrixXd both(2, 3);
  both << one, other;
  for (const Method method : { Method::Exact, Method::Dijkstra })
  {
    const Eigen::VectorXd nearest =
      Distances(mesh, one, method).cwiseMin(Distances(mesh, other, method));
    EXPECT_LT(
      (Distances(mesh, both, method) - nearest).cwiseAbs().maxCoeff(), 1e-12 * nearest.maxCoeff());
  }
}

TEST(GeodesicDistance, SaysWhereNoPathLeads)
{
  // Two spheres, and a point that no triangle uses.
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const Eigen::Index points = sphere.Points.rows();
  shape::Mesh two = shapetest::Twice(sphere, { 5, 0, 0 });
  two.Points.conservativeResize(2 * points + 1, 3);
  two.Points.bottomRows(1).setZero();
  for (const Method method : { Method::Exact, Method::Dijkstra, Method::Heat })
  {
    shape::GeodesicDistanceOptions options;
    options.Method = method;
    const shape::GeodesicDistanceResult result =
      shape::ComputeGeodesicDistance(two, Eigen::RowVector3d(0.1, 0.2, 1.0), options);
    EXPECT_EQ(result.Unreached, points + 1);
    EXPECT_EQ(result.Distances.tail(points + 1), Eigen::VectorXd::Constant(points + 1, -1.0));
    EXPECT_LT(
      (result.Distances.head(points) - Angles(sphere, { 0.1, 0.2, 1.0 })).cwiseAbs().maxCoeff(),
      0.3);
  }
}

TEST(GeodesicDistance, HeatIsNearToStraightOnTheBorder)
{
  const shape::Mesh square = shapetest::FlatSquare(40, 0.3);
  const Eigen::RowVector3d seed(-0.8, 0.1, 0.0);
  const Eigen::VectorXd straight = (square.Points.rowwise() - seed).rowwise().norm();
  EXPECT_LT((Distances(square, seed, Method::Heat) - straight).cwiseAbs().maxCoeff(), 0.1);
  EXPECT_LT((Distances(square, seed, Method::Heat) - straight).cwiseAbs().mean(), 0.02);
}

TEST(GeodesicDistance, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(1);
  EXPECT_THROW(shape::ComputeGeodesicDistance(sphere, Eigen::MatrixXd(0, 3)), shape::InvalidInput);
  EXPECT_THROW(shape::ComputeGeodesicDistance(
                 sphere, Eigen::RowVector3d(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0)),
    shape::InvalidInput);
  shape::Mesh broken = sphere;
  broken.Triangles.row(0).reverseInPlace();
  shape::GeodesicDistanceOptions options;
  options.Method = Method::Exact;
  const Eigen::RowVector3d seed(1.0, 0.0, 0.0);
  EXPECT_THROW(shape::ComputeGeodesicDistance(broken, seed, options), shape::InvalidInput);
  // Heat needs no orientation.
  EXPECT_LT((Distances(broken, seed, Method::Heat) - Distances(sphere, seed, Method::Heat))
              .cwiseAbs()
              .maxCoeff(),
    1e-9);
}
