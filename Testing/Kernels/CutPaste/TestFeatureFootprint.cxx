// Facts checked: a feature with a flat rim stands on the plane, whatever it is like within; one cut
// from a sphere stands on the sphere, its rim as far from the middle as along the surface; a
// surface knows where the loop of what was cut from it is.

#include "Base/Errors.h"
#include "CutPaste/FootprintLayout.h"
#include "Mesh/BoundaryLoops.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace
{

TEST(FeatureFootprint, AFlatRimStandsOnAPlane)
{
  shape::Mesh bump = shapetest::FlatDisk(12);
  for (Eigen::Index i = 0; i < bump.Points.rows(); ++i)
  {
    const double share = bump.Points.row(i).squaredNorm() / 0.5;
    bump.Points(i, 2) = share < 1.0 ? std::pow(1.0 - share, 2) : 0.0;
  }
  const std::vector<int> loop = shape::FindManifoldBoundaryLoops(bump)[0];
  const shape::FeatureFootprint base = shape::BuildFootprintOnOwnFill(bump, loop);
  ASSERT_EQ(base.Loop, loop);
  EXPECT_LT((base.Normals.rowwise() - Eigen::RowVector3d(0, 0, 1)).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_LT((base.Normal - Eigen::RowVector3d(0, 0, 1)).norm(), 1e-6);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const double apart = (bump.Points.row(loop[i]) - bump.Points.row(loop[j])).norm();
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
      EXPECT_NEAR((base.LoopPositions.row(a) - base.LoopPositions.row(b)).norm(), apart, 1e-6);
    }
  }
}

/// The part of the unit sphere above a height.
shape::Mesh Cap(int level, double height)
{
  shape::Mesh cap = shapetest::Icosphere(level);
  std::vector<int> above;
  for (int t = 0; t < static_cast<int>(cap.Triangles.rows()); ++t)
  {
    if (shape::GetCorners(cap, t).col(2).minCoeff() > height)
    {
      above.push_back(t);
    }
  }
  cap.Triangles = Eigen::MatrixXi(cap.Triangles(above, Eigen::all));
  return cap;
}

TEST(FeatureFootprint, ACapOfASphereStandsOnTheSphere)
{
  const shape::Mesh cap = Cap(5, 0.7);
  const std::vector<int> loop = shape::FindManifoldBoundaryLoops(cap)[0];
  const shape::FeatureFootprint base = shape::BuildFootprintOnOwnFill(cap, loop);
  for (Eigen::Index i = 0; i < base.LoopPositions.rows(); ++i)
  {
    const Eigen::RowVector3d position = cap.Points.row(loop[i]);
    EXPECT_NEAR(base.LoopPositions.row(i).norm(), std::acos(position.z()), 0.03);
    EXPECT_LT(std::acos(std::min(1.0, position.dot(base.Normals.row(i)))), 0.1);
  }
  EXPECT_GT(base.Normal.z(), 0.999);
}

TEST(FeatureFootprint, ASurfaceKnowsTheLoopOfWhatWasCutFromIt)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const std::vector<int> loop = shape::FindManifoldBoundaryLoops(Cap(4, 0.7))[0];
  std::vector<int> numbers(loop.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const shape::FeatureFootprint base =
    shape::BuildFootprintsOnSurface(sphere, { { { 0, 0, 1 }, numbers, loop } }).front();
  EXPECT_EQ(base.Loop, numbers);
  for (Eigen::Index i = 0; i < base.LoopPositions.rows(); ++i)
  {
    EXPECT_LT((base.Normals.row(i) - sphere.Points.row(loop[i])).norm(), 0.02);
    EXPECT_NEAR(base.LoopPositions.row(i).norm(), std::acos(sphere.Points(loop[i], 2)), 0.01);
  }
  const shape::Mesh two = shapetest::Twice(sphere, { 0, 0, 5 });
  EXPECT_THROW(
    shape::BuildFootprintsOnSurface(two, { { { 0, 0, 6 }, numbers, loop } }), shape::InvalidInput);
}

TEST(FeatureFootprint, TheMiddleOfTrianglesIsOnThem)
{
  const shape::Mesh cap = Cap(4, 0.5);
  std::vector<int> all(cap.Triangles.rows());
  std::iota(all.begin(), all.end(), 0);
  const Eigen::RowVector3d middle = shape::FindCenterOfTriangles(cap, all);
  EXPECT_LT((middle - Eigen::RowVector3d(0, 0, 1)).norm(), 0.02);
}

} // namespace
