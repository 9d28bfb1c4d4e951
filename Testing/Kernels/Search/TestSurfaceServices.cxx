#include "Base/Errors.h"
#include "Distance/SignedDistance.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Solids/IsoSurface.h"
#include "Support/RandomPoints.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

Eigen::MatrixXd RandomPoints(int count, double halfEdge)
{
  return shapetest::RandomPointsInCube(count, halfEdge, 7);
}

/// The least distance to any edge, and to the plane of any triangle that lies below the point.
double BruteForceDistance(const shape::Mesh& mesh, const Eigen::RowVector3d& p)
{
  double best = std::numeric_limits<double>::infinity();
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    Eigen::RowVector3d corner[3];
    for (int k = 0; k < 3; ++k)
    {
      corner[k] = mesh.Points.row(mesh.Triangles(t, k));
    }
    const Eigen::RowVector3d normal =
      (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    bool above = true;
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::RowVector3d a = corner[k], edge = corner[(k + 1) % 3] - a;
      const double along = std::clamp((p - a).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (p - a - along * edge).norm());
      above = above && edge.cross(p - a).dot(normal) >= 0.0;
    }
    if (above)
    {
      best = std::min(best, std::abs((p - corner[0]).dot(normal)));
    }
  }
  return best;
}

/// Of a wedge whose sharp edge is on the z axis.
void ExpectPositiveBehindTheSharpEdge(const shape::Mesh& wedge)
{
  Eigen::MatrixXd outside = RandomPoints(300, 0.9);
  outside.col(0).array() -= 0.9;
  const shape::SignedDistance field(shape::OrientOutwards(wedge));
  EXPECT_GT(field.Evaluate(outside).Distances.minCoeff(), 0.0);
}

} // namespace

TEST(ClosestPoint, FindsVerticesAsVertices)
{
  // The last point lies on the long edge of a triangle without area.
  const shape::Mesh sphere = shapetest::Icosphere(2);
  for (int edge = 0; edge < 3; ++edge)
  {
    const shape::Mesh split = shapetest::WithFlatTriangle(sphere, 5, edge);
    const shape::ClosestPoints found = shape::SurfaceLocator(split).Find(split.Points);
    EXPECT_EQ(shape::FindNearestCorners(found, split.Triangles),
      Eigen::VectorXi::LinSpaced(
        split.Points.rows(), 0, static_cast<int>(split.Points.rows()) - 1));
    EXPECT_EQ(found.Barycentrics.rowwise().maxCoeff().minCoeff(), 1.0);
  }
}

TEST(ClosestPoint, AgreesWithTheSearchOfEveryTriangle)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 24, 12);
  const Eigen::MatrixXd points = RandomPoints(500, 2.0);
  const shape::ClosestPoints found = shape::SurfaceLocator(torus).Find(points);
  const Eigen::MatrixXd positions = shape::PullBack(found, torus.Triangles, torus.Points);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    EXPECT_NEAR(found.Distances(i), BruteForceDistance(torus, points.row(i)), 1e-12);
    EXPECT_NEAR((positions.row(i) - points.row(i)).norm(), found.Distances(i), 1e-12);
    EXPECT_GE(found.Barycentrics.row(i).minCoeff(), 0.0);
    EXPECT_NEAR(found.Barycentrics.row(i).sum(), 1.0, 1e-14);
  }
}

TEST(ClosestPoint, PlacesOnTheSurfaceFindThemselvesHoweverOftenTheyAreGiven)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 24, 12);
  const Eigen::MatrixXd places = shape::ComputeOffCentres(torus);
  Eigen::MatrixXd points(3 * places.rows(), 3);
  for (Eigen::Index t = 0; t < places.rows(); ++t)
  {
    points.middleRows(3 * t, 2).rowwise() = places.row(t);
    points.row(3 * t + 2) = torus.Points.row(torus.Triangles(t, 0));
  }
  const shape::ClosestPoints found = shape::SurfaceLocator(torus).Find(points);
  for (Eigen::Index t = 0; t < places.rows(); ++t)
  {
    EXPECT_EQ(found.Triangles(3 * t), t);
    EXPECT_EQ(found.Triangles(3 * t + 1), t);
  }
  EXPECT_LT(found.Distances.maxCoeff(), 1e-15);
}

TEST(ClosestPoint, AGuessChangesNoDistance)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 24, 12);
  const shape::SurfaceLocator locator(torus);
  const Eigen::MatrixXd points = RandomPoints(200, 1.6);
  const shape::ClosestPoints found = locator.Find(points);
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    const int guess = (37 * i) % static_cast<int>(torus.Triangles.rows());
    for (const int triangle : { -1, guess, int(found.Triangles(i)) })
    {
      const shape::ClosestPoint position = locator.FindOne(points.row(i), triangle);
      EXPECT_NEAR(position.Distance, found.Distances(i), 1e-14);
      EXPECT_NEAR((position.Position - points.row(i)).norm(), position.Distance, 1e-15);
      const Eigen::RowVector3d again =
        position.Barycentric * shape::GetCorners(torus, position.Triangle);
      EXPECT_LT((again - position.Position).norm(), 1e-15);
    }
  }
}

TEST(ClosestPoint, TheLargestDistanceIsTheMaximumOfAll)
{
  const shape::SurfaceLocator torus(shapetest::Torus(1.0, 0.4, 24, 12));
  // More than one chunk, on and off the surface, the farthest anywhere among them.
  for (const double halfEdge : { 0.1, 1.5, 40.0 })
  {
    const Eigen::MatrixXd points = RandomPoints(5000, halfEdge);
    EXPECT_DOUBLE_EQ(torus.FindLargestDistance(points), torus.Find(points).Distances.maxCoeff());
  }
  EXPECT_LT(torus.FindLargestDistance(torus.GetSurface().Points()), 1e-15);
}

TEST(ClosestPoint, OnlyDistancesThatAreEnoughMayBeTooLarge)
{
  const shape::SurfaceLocator torus(shapetest::Torus(1.0, 0.4, 24, 12));
  const Eigen::MatrixXd points = RandomPoints(2000, 1.5);
  const Eigen::VectorXd exact = torus.Find(points).Distances;
  constexpr double enough = 0.3;
  const shape::ClosestPoints found = torus.Find(points, {}, enough);
  int larger = 0;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    EXPECT_NEAR((found.Positions.row(i) - points.row(i)).norm(), found.Distances(i), 1e-14);
    if (exact(i) >= enough)
    {
      EXPECT_DOUBLE_EQ(found.Distances(i), exact(i));
    }
    else
    {
      EXPECT_LT(found.Distances(i), enough);
      EXPECT_GE(found.Distances(i), exact(i) - 1e-14);
      larger += found.Distances(i) > exact(i) + 1e-6;
    }
  }
  EXPECT_GT(larger, 100); // otherwise nothing was saved
}

TEST(ClosestPoint, ATriangleWithoutAreaIsItsLongestEdge)
{
  shape::Mesh mesh{ Eigen::MatrixXd(3, 3), Eigen::MatrixXi(1, 3) };
  mesh.Points << 0, 0, 0, 0, 0, 0, 2, 0, 0;
  mesh.Triangles << 0, 1, 2;
  Eigen::MatrixXd points(2, 3);
  points << 1.5, 1, 0, -3, 0, 4;
  const shape::ClosestPoints found = shape::SurfaceLocator(mesh).Find(points);
  EXPECT_NEAR(found.Distances(0), 1.0, 1e-15);
  EXPECT_NEAR(found.Distances(1), 5.0, 1e-15);
  mesh.Triangles.resize(0, 3);
  EXPECT_THROW(shape::SurfaceLocator{ mesh }, shape::InvalidInput);
}

TEST(SignedDistance, OfASphereAndATorusIsTheClosedFormUpToTheFacets)
{
  const Eigen::MatrixXd points = RandomPoints(2000, 1.6);
  // A facet's middle lies the sagitta below the smooth surface: h^2 / (8 r).
  const Eigen::VectorXd sphere =
    shape::SignedDistance(shapetest::Icosphere(4)).Evaluate(points).Distances;
  const Eigen::VectorXd torus =
    shape::SignedDistance(shapetest::Torus(1.0, 0.4, 120, 60)).Evaluate(points).Distances;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::RowVector3d p = points.row(i);
    EXPECT_NEAR(sphere(i), p.norm() - 1.0, 2e-3);
    EXPECT_NEAR(torus(i), std::hypot(p.head<2>().norm() - 1.0, p(2)) - 0.4, 2e-3);
  }
}

TEST(SignedDistance, HasTheRightSignWhereTheClosestPointIsAnEdgeOrACorner)
{
  // A thin wedge: the nearest face alone would give the wrong sign behind its sharp edge.
  shape::Mesh wedge{ Eigen::MatrixXd(4, 3), Eigen::MatrixXi(4, 3) };
  wedge.Points << 0, 0, -1, 0, 0, 1, 4, 0.1, 0, 4, -0.1, 0;
  wedge.Triangles << 0, 1, 2, 1, 0, 3, 0, 2, 3, 1, 3, 2;
  ExpectPositiveBehindTheSharpEdge(wedge);
  Eigen::MatrixXd inside(1, 3);
  inside << 3.0, 0.0, 0.0;
  EXPECT_LT(shape::SignedDistance(shape::OrientOutwards(wedge)).Evaluate(inside).Distances(0), 0.0);
}

TEST(SignedDistance, HasTheRightSignBesideFlatTriangles)
{
  // The wedge again, with a flat triangle in its sharp edge: it has no normal to add to the face's.
  shape::Mesh wedge{ Eigen::MatrixXd(5, 3), Eigen::MatrixXi(6, 3) };
  wedge.Points << 0, 0, -1, 0, 0, 1, 4, 0.1, 0, 4, -0.1, 0, 0, 0, 0;
  wedge.Triangles << 0, 1, 2, 1, 4, 3, 4, 0, 3, 0, 2, 3, 1, 3, 2, 1, 0, 4;
  ExpectPositiveBehindTheSharpEdge(wedge);
  Eigen::MatrixXd inside(2, 3);
  inside << 3.0, 0.0, 0.0, 0.02, 0.0, 0.1;
  EXPECT_LT(
    shape::SignedDistance(shape::OrientOutwards(wedge)).Evaluate(inside).Distances.maxCoeff(), 0.0);
}

TEST(ClosestPoint, ADistanceThatOverflowsIsRefused)
{
  const shape::SurfaceLocator locator(shapetest::Icosphere(1));
  EXPECT_THROW(locator.Find(Eigen::RowVector3d(1e200, 0.0, 0.0)), shape::InvalidInput);
}

TEST(IsoSurface, OfASphereIsClosedFacesOutwardsAndHasItsVolume)
{
  shape::SampledGrid grid;
  grid.Origin = Eigen::RowVector3d::Constant(-1.25);
  grid.Spacing = 0.1;
  grid.Counts = Eigen::RowVector3i::Constant(26);
  grid.Values.resize(grid.Counts.prod());
  for (int z = 0; z < 26; ++z)
  {
    for (int y = 0; y < 26; ++y)
    {
      for (int x = 0; x < 26; ++x)
      {
        grid.Values(grid.Index(x, y, z)) = grid.Point(x, y, z).norm();
      }
    }
  }
  const shape::Mesh surface = shape::ExtractIsoSurface(grid, 1.0);
  EXPECT_EQ(shape::RequireClosedSurface(surface, "the iso-surface").EulerNumber, 2);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(surface), 4.0 / 3.0 * M_PI, 0.03);
  EXPECT_EQ(shape::ExtractIsoSurface(grid, 9.0).Triangles.rows(), 0);
}
