#include "Base/Errors.h"
#include "Correspondence/Functional/HeatKernelMap.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// Where the nearest point to a place is.
int PointAt(const shape::Mesh& mesh, const Eigen::RowVector3d& position)
{
  Eigen::Index at = 0;
  (mesh.Points.rowwise() - position).rowwise().squaredNorm().minCoeff(&at);
  return static_cast<int>(at);
}

} // namespace

TEST(HeatKernelMap, OnePointTellsAllPointsOfACopyApart)
{
  const shape::Mesh a = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  const shapetest::Renumbered copy = shapetest::Renumber(a, 5);
  shape::Mesh b = copy.Mesh; // elsewhere, and larger
  const Eigen::Matrix3d turn = shapetest::Rotation(2.0, { 1, 2, 3 });
  b.Points = (7.0 * b.Points * turn.transpose()).rowwise() + Eigen::RowVector3d(1, 2, 3);
  const auto wanted = [&](const Eigen::VectorXi& ids) -> Eigen::MatrixXd
  { return b.Points(ids, Eigen::all); };
  const shape::SurfaceMaps maps = shape::ComputeHeatKernelMap(a, b, { { 100, copy.NewOf(100) } });
  EXPECT_LT(shapetest::MapErrors(maps.AToB, b, wanted(copy.NewOf)).maxCoeff(), 1e-4);
  Eigen::MatrixXd back(b.Points.rows(), 3);
  for (Eigen::Index i = 0; i < a.Points.rows(); ++i)
  {
    back.row(copy.NewOf(i)) = a.Points.row(i);
  }
  EXPECT_LT(shapetest::MapErrors(maps.BToA, a, back).maxCoeff(), 1e-4);
}

TEST(HeatKernelMap, BendingAPlateChangesNothing)
{
  // With a border, and other triangles.
  const auto plate = [](int cells)
  {
    shape::Mesh mesh = shapetest::FlatSquare(cells, 0.0);
    mesh.Points.col(1) *= 0.6;
    return mesh;
  };
  const auto bend = [](Eigen::MatrixXd points)
  {
    constexpr double radius = 2.0 / M_PI;
    const Eigen::ArrayXd angles = points.col(0).array() / radius;
    points.col(0) = radius * angles.sin();
    points.col(2) = radius * angles.cos();
    return points;
  };
  const shape::Mesh a = plate(40);
  shape::Mesh b = plate(36);
  const auto worst = [&](const Eigen::RowVector3d& position)
  {
    const shape::Mesh bent{ bend(b.Points), b.Triangles };
    const shape::SurfaceMaps maps =
      shape::ComputeHeatKernelMap(a, bent, { { PointAt(a, position), PointAt(b, position) } });
    return shapetest::MapErrors(maps.AToB, bent, bend(a.Points)).maxCoeff();
  };
  EXPECT_LT(worst({ 0.5, 0.3, 0.0 }), 0.05); // the point is on no axis of symmetry
  EXPECT_GT(worst({ 0.0, 0.0, 0.0 }), 0.3);  // from the middle all four quarters look alike
}

TEST(HeatKernelMap, OtherTrianglesAreTheSameSurface)
{
  const shape::Mesh a = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  const shape::Mesh b = shapetest::BumpySphere(4, shapetest::Rotation(0.7, { 3, -1, 1 }));
  shape::Landmarks landmarks;
  double before = 1.0;
  for (const Eigen::RowVector3d& tip :
    { Eigen::RowVector3d(3, 0, 0), Eigen::RowVector3d(0.2, -1, -1.6) })
  {
    landmarks.push_back({ PointAt(a, tip), PointAt(b, tip) });
    const shape::SurfaceMaps maps = shape::ComputeHeatKernelMap(a, b, landmarks);
    const double error = shapetest::MapErrors(maps.AToB, b, a.Points).mean();
    EXPECT_LT(error, 0.9 * before);
    before = error;
  }
  EXPECT_LT(before, 0.02);
  const shape::SurfaceMaps automatic = shape::ComputeHeatKernelMap(a, b, {});
  EXPECT_LT(shapetest::MapErrors(automatic.AToB, b, a.Points).mean(), 0.02);
}

TEST(HeatKernelMap, EachComponentNeedsALandmark)
{
  const shape::Mesh one = shapetest::BumpySphere(2, Eigen::Matrix3d::Identity());
  const shape::Mesh other = shapetest::Torus(2.0, 0.7, 24, 12);
  const shape::Mesh a = shapetest::Joined({ one, shapetest::Shifted(other, { 10, 0, 0 }) }),
                    b = shapetest::Joined({ other, shapetest::Shifted(one, { -10, 0, 0 }) });
  const auto n = static_cast<int>(one.Points.rows()), m = static_cast<int>(other.Points.rows());
  const shape::SurfaceMaps maps = shape::ComputeHeatKernelMap(a, b, { { 5, m + 5 }, { n + 9, 9 } });
  const Eigen::VectorXi targets = shape::FindNearestCorners(maps.AToB, b.Triangles);
  EXPECT_GE(targets.head(n).minCoeff(), m);
  EXPECT_LT(targets.tail(m).maxCoeff(), m);
  Eigen::MatrixXd wanted(n + m, 3);
  wanted << b.Points.bottomRows(n), b.Points.topRows(m);
  // The torus's own mirror image keeps the landmark in its place.
  EXPECT_LT(shapetest::MapErrors(maps.AToB, b, wanted).head(n).maxCoeff(), 1e-4);
}

TEST(HeatKernelMap, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const shape::Mesh both = shapetest::Twice(sphere);
  EXPECT_REFUSED(
    shape::ComputeHeatKernelMap(sphere, both, { { 0, 0 } }), "surface B has 2 components");
  EXPECT_REFUSED(
    shape::ComputeHeatKernelMap(both, sphere, { { 0, 0 } }), "surface A has 2 components");
  EXPECT_REFUSED(shape::ComputeHeatKernelMap(sphere, sphere, { { 0, 162 } }), "162");
  EXPECT_REFUSED(shape::ComputeHeatKernelMap(sphere, sphere, { { -1, 0 } }), "-1");
  EXPECT_REFUSED(
    shape::ComputeHeatKernelMap(sphere, sphere, { { 0, 0 } }, { 1, 25 }), "Eigenpairs is 1");
  EXPECT_REFUSED(shape::ComputeHeatKernelMap(sphere, sphere, { { 0, 0 } }, { 9, 0 }), "Times is 0");
  shape::Mesh loose = sphere;
  loose.Points.conservativeResize(163, 3);
  loose.Points.row(162).setZero();
  EXPECT_THROW(shape::ComputeHeatKernelMap(sphere, loose, { { 0, 0 } }), shape::InvalidInput);
}
