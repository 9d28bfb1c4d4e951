#include "Base/Errors.h"
#include "Correspondence/Pair/CoarsePair.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Remesh/Coarsening.h"
#include "Support/MatchingShapes.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

/// Where fine points are on the coarse surface.
Eigen::MatrixXd Images(const shape::CoarseSurface& coarse)
{
  return shape::PullBack(coarse.Positions, coarse.Surface.Triangles(), coarse.Surface.Points());
}

TEST(CoarsenSurface, KeepsTopologyAndStaysNearTheSurface)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.8, 120, 60);
  const shape::CoarseSurface coarse = shape::CoarsenSurface(torus, 700);
  EXPECT_EQ(coarse.Surface.Points().rows(), 700);
  const shape::Topology topology = shape::RequireClosedSurface(coarse.Surface, "the coarse torus");
  EXPECT_EQ(topology.EulerNumber, 0);
  EXPECT_EQ(topology.Components, 1);
  // Half the longest chord of triangles of this size on the tighter circle is 0.2: sagitta 0.025.
  EXPECT_LT((Images(coarse) - torus.Points).rowwise().norm().maxCoeff(), 0.04);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(coarse.Surface), shape::ComputeEnclosedVolume(torus),
    0.03 * shape::ComputeEnclosedVolume(torus));
}

TEST(CoarsenSurface, PointsThatStayAreWhereTheyWere)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const std::vector<int> kept = { 5, 77, 1200, 2000 };
  const shape::CoarseSurface coarse = shape::CoarsenSurface(sphere, 200, kept);
  EXPECT_TRUE(std::is_sorted(coarse.Points.begin(), coarse.Points.end()));
  const Eigen::MatrixXd images = Images(coarse);
  for (const int point : coarse.Points)
  {
    EXPECT_EQ(images.row(point), sphere.Points.row(point));
  }
  for (const int point : kept)
  {
    EXPECT_TRUE(std::binary_search(coarse.Points.begin(), coarse.Points.end(), point)) << point;
  }
}

TEST(CoarsenSurface, TheBorderStaysOneLoop)
{
  const shape::Mesh disk = shapetest::FlatDisk(24);
  const shape::CoarseSurface coarse = shape::CoarsenSurface(disk, 150);
  const shape::Topology topology = shape::RequireManifold(coarse.Surface, "the coarse disk");
  EXPECT_EQ(topology.EulerNumber, 1);
  EXPECT_EQ(topology.BoundaryLoops, 1);
  EXPECT_EQ(coarse.Surface.Points().rows(), 150);
  // Flat: all triangles keep their side, and what they cover is a little less than the disk.
  EXPECT_GT(shape::ComputeAreaVectors(coarse.Surface).col(2).minCoeff(), 0.0);
  EXPECT_GT(
    shape::ComputePointAreas(coarse.Surface).sum(), 0.95 * shape::ComputePointAreas(disk).sum());
}

TEST(CoarsenSurface, EndsAtATetrahedronAtLeast)
{
  const shape::CoarseSurface coarse = shape::CoarsenSurface(shapetest::Icosphere(2), 4);
  EXPECT_GE(coarse.Surface.Points().rows(), 4);
  EXPECT_EQ(shape::RequireClosedSurface(coarse.Surface, "the rest").EulerNumber, 2);
  EXPECT_THROW(shape::CoarsenSurface(shapetest::Icosphere(1), 3), shape::InvalidInput);
}

TEST(CoarsenSurface, LargeFansShrinkFromTheirRims)
{
  constexpr int loop = 5000;
  shape::Mesh fan{ Eigen::MatrixXd::Zero(loop + 1, 3), Eigen::MatrixXi(loop, 3) };
  for (int i = 0; i < loop; ++i)
  {
    const double angle = 2.0 * M_PI * i / loop;
    fan.Points.row(i) << std::cos(angle), std::sin(angle), 0.0;
    fan.Triangles.row(i) << i, (i + 1) % loop, loop;
  }
  // Its triangles are slim, those of a coarser one less so.
  const shape::CoarseSurface coarse = shape::CoarsenSurface(fan, 60);
  EXPECT_EQ(coarse.Surface.Points().rows(), 60);
  EXPECT_EQ(shape::RequireManifold(coarse.Surface, "the fan").BoundaryLoops, 1);
  EXPECT_GT(shape::ComputeAreaVectors(coarse.Surface).col(2).minCoeff(), 0.0);
  EXPECT_GT(shape::ComputePointAreas(coarse.Surface).sum(), 0.9 * M_PI);
}

TEST(CoarsenSurface, RefusesPointsWithoutATriangle)
{
  shape::Mesh sphere = shapetest::Icosphere(2);
  sphere.Points.conservativeResize(sphere.Points.rows() + 1, 3);
  sphere.Points.bottomRows(1).setZero();
  EXPECT_THROW(shape::CoarsenSurface(sphere, 20), shape::InvalidInput);
}

TEST(LocateOnFinerSurface, LeadBackToThePoints)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.8, 120, 60);
  const shape::CoarseSurface coarse = shape::CoarsenSurface(torus, 1000);
  const shape::SurfacePoints back = shape::LocateOnFinerSurface(coarse, torus, coarse.Positions);
  const Eigen::VectorXd errors =
    (shape::PullBack(back, torus.Triangles, torus.Points) - torus.Points).rowwise().norm();
  // Both steps go along the normal but for the surface's bend: a tenth of an edge, 0.1.
  EXPECT_LT(errors.mean(), 0.01);
  EXPECT_LT(errors.maxCoeff(), 0.05);
}

TEST(CoarsePair, MapsOfCoarseSurfacesAreThoseOfTheFineOnes)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.8, 120, 60);
  const shapetest::Renumbered copy = shapetest::Renumber(torus, 2);
  shape::Landmarks landmarks;
  for (int point = 0; point < torus.Points.rows(); point += 997)
  {
    landmarks.push_back({ point, copy.NewOf(point) });
  }
  const shape::CoarsePair pair(torus, copy.Mesh, landmarks, 1500);
  EXPECT_TRUE(pair.IsCoarser());
  EXPECT_EQ(pair.OnFine(pair.OnCoarse(landmarks)), landmarks);
  // The coarse surfaces are not the same, but both are on the torus: the closest place.
  const auto closest = [](const shape::Mesh& from, const shape::Mesh& to)
  {
    shape::SurfacePoints map{ Eigen::VectorXi(from.Points.rows()),
      Eigen::MatrixXd::Zero(from.Points.rows(), 3) };
    for (Eigen::Index i = 0; i < from.Points.rows(); ++i)
    {
      Eigen::Index nearest = 0;
      (to.Points.rowwise() - from.Points.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
      for (Eigen::Index t = 0; t < to.Triangles.rows(); ++t)
      {
        for (int k = 0; k < 3; ++k)
        {
          if (to.Triangles(t, k) == nearest)
          {
            map.Triangles(i) = static_cast<int>(t);
            map.Barycentrics.row(i) = Eigen::RowVector3d::Unit(k);
          }
        }
      }
    }
    return map;
  };
  const shape::SurfaceMaps maps =
    pair.OnFine(shape::SurfaceMaps{ closest(pair.A(), pair.B()), closest(pair.B(), pair.A()) });
  const Eigen::MatrixXd there = shape::PullBack(maps.AToB, copy.Mesh.Triangles, copy.Mesh.Points);
  // Nearest points are half an edge of the coarse surface, 0.2, off on average.
  EXPECT_LT((there - torus.Points).rowwise().norm().mean(), 0.1);
  EXPECT_EQ(there.rows(), torus.Points.rows());
}

TEST(CoarsePair, SmallSurfacesStayAsTheyAre)
{
  const shape::Surface sphere = shapetest::Icosphere(2);
  const shape::CoarsePair pair(sphere, sphere, {}, 1000);
  EXPECT_FALSE(pair.IsCoarser());
  EXPECT_EQ(&pair.A().Points(), &sphere.Points());
}

} // namespace
