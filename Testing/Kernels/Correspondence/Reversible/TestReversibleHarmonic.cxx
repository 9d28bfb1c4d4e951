#include "Base/Errors.h"
#include "Correspondence/Landmarks/LandmarkCells.h"
#include "Correspondence/Reversible/ReversibleHarmonic.h"
#include "Support/MatchingShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

/// Ends of a bumpy sphere's five bumps and places between them.
shape::Landmarks BumpLandmarks(const shapetest::Renumbered& copy, const shape::Mesh& mesh)
{
  Eigen::Matrix<double, 7, 3> positions;
  positions << 1, 0, 0, -0.4, 0.9, 0, -0.5, -0.6, 0.6, 0.1, -0.5, -0.8, 0.2, 0.3, 0.9, 0.5, 0.6,
    -0.7, -0.8, -0.1, -0.6;
  shape::Landmarks landmarks;
  for (const auto& position : positions.rowwise())
  {
    Eigen::Index point = 0;
    (mesh.Points.rowwise().normalized() * position.normalized().transpose()).maxCoeff(&point);
    landmarks.push_back({ static_cast<int>(point), copy.NewOf(point) });
  }
  return landmarks;
}

double RoundTrip(const shape::SurfaceMaps& maps, const shape::Mesh& a, const shape::Mesh& b)
{
  const Eigen::MatrixXd there = shape::PullBack(maps.BToA, a.Triangles, a.Points);
  return (shape::PullBack(maps.AToB, b.Triangles, there) - a.Points).rowwise().norm().mean();
}

TEST(LandmarkCells, TakePointsToThePartnerOfTheNearestLandmark)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const shape::Landmarks landmarks = { { 0, 3 }, { 5, 7 }, { 40, 90 } };
  const shape::SurfaceMaps maps = shape::MapByLandmarkCells(sphere, sphere, landmarks);
  const Eigen::VectorXi targets = shape::FindNearestCorners(maps.AToB, sphere.Triangles);
  for (Eigen::Index i = 0; i < targets.size(); ++i)
  {
    double minimum = std::numeric_limits<double>::infinity(), own = minimum;
    for (const auto& [a, b] : landmarks)
    {
      const double angle =
        std::acos(std::clamp(sphere.Points.row(i).dot(sphere.Points.row(a)), -1.0, 1.0));
      minimum = std::min(minimum, angle);
      own = targets(i) == b ? angle : own;
    }
    EXPECT_LT(own, minimum + 0.05); // the error of distances by heat
  }
  EXPECT_THROW(shape::MapByLandmarkCells(sphere, sphere, {}), shape::InvalidInput);
}

TEST(ReversibleHarmonic, FindsACopyFromLandmarksAndKeepsThem)
{
  const shape::Mesh mesh = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  shapetest::Renumbered copy = shapetest::Renumber(mesh, 7);
  copy.Mesh.Points = 2.0 * copy.Mesh.Points * shapetest::Rotation(0.7, { 1.0, 1.0, 0.2 });
  const shape::Landmarks landmarks = BumpLandmarks(copy, mesh);
  const shape::SurfaceMaps cells = shape::MapByLandmarkCells(mesh, copy.Mesh, landmarks);
  const shape::ReversibleHarmonicResult result =
    shape::ComputeReversibleHarmonicMap(mesh, copy.Mesh, cells, landmarks);
  const Eigen::MatrixXd wanted = copy.Mesh.Points(copy.NewOf, Eigen::all);
  const double before = shapetest::MapErrors(cells.AToB, copy.Mesh, wanted).mean(),
               after = shapetest::MapErrors(result.Maps.AToB, copy.Mesh, wanted).mean();
  EXPECT_GT(before, 0.1);
  EXPECT_LT(after, 0.02);
  EXPECT_LT(RoundTrip(result.Maps, mesh, copy.Mesh), 0.1 * RoundTrip(cells, mesh, copy.Mesh));
  const Eigen::MatrixXd there =
    shape::PullBack(result.Maps.AToB, copy.Mesh.Triangles, copy.Mesh.Points);
  for (const auto& [a, b] : landmarks)
  {
    EXPECT_LT((there.row(a) - copy.Mesh.Points.row(b)).norm(), 1e-12);
  }
}

TEST(ReversibleHarmonic, TheEnergyFallsWhileItsWeightsStay)
{
  const shape::Mesh mesh = shapetest::Torus(2.0, 0.8, 40, 20);
  const shapetest::Renumbered copy = shapetest::Renumber(mesh, 2);
  shape::Landmarks landmarks;
  for (int point = 0; point < mesh.Points.rows(); point += 97)
  {
    landmarks.push_back({ point, copy.NewOf(point) });
  }
  shape::ReversibleHarmonicOptions options;
  options.FirstAlpha = options.Alpha;
  options.BetaStep = 0.1;
  options.BetaSteps = 1;
  options.Tolerance = 0.0;
  options.PinLandmarks = false;
  options.MaximumIterations = 12;
  const shape::ReversibleHarmonicResult result = shape::ComputeReversibleHarmonicMap(
    mesh, copy.Mesh, shape::MapByLandmarkCells(mesh, copy.Mesh, landmarks), landmarks, options);
  ASSERT_EQ(result.Energies.size(), 12U);
  for (std::size_t k = 1; k < result.Energies.size(); ++k)
  {
    EXPECT_LE(result.Energies[k], result.Energies[k - 1] * (1.0 + 1e-9)) << k;
  }
}

TEST(ReversibleHarmonic, OfASurfaceWithBorder)
{
  const shape::Mesh disk = shapetest::FlatDisk(16);
  const shapetest::Renumbered copy = shapetest::Renumber(disk, 4);
  shape::Landmarks landmarks;
  for (int point = 0; point < disk.Points.rows(); point += 61)
  {
    landmarks.push_back({ point, copy.NewOf(point) });
  }
  const shape::SurfaceMaps maps = shape::ComputeReversibleHarmonicMap(
    disk, copy.Mesh, shape::MapByLandmarkCells(disk, copy.Mesh, landmarks), landmarks)
                                    .Maps;
  const Eigen::MatrixXd wanted = copy.Mesh.Points(copy.NewOf, Eigen::all);
  EXPECT_LT(shapetest::MapErrors(maps.AToB, copy.Mesh, wanted).mean(), 0.02);
}

TEST(ReversibleHarmonic, OfLevelsIsAsNearAndKeepsLandmarks)
{
  const shape::Mesh mesh = shapetest::BumpySphere(5, Eigen::Matrix3d::Identity());
  shapetest::Renumbered copy = shapetest::Renumber(mesh, 7);
  copy.Mesh.Points = copy.Mesh.Points * shapetest::Rotation(0.7, { 1.0, 1.0, 0.2 });
  const shape::Landmarks landmarks = BumpLandmarks(copy, mesh);
  const shape::CoarsePair pair(mesh, copy.Mesh, landmarks, 2000);
  const shape::Landmarks coarse = pair.OnCoarse(landmarks);
  const shape::ReversibleHarmonicResult result = shape::RefineReversibleHarmonicMap(
    pair, shape::MapByLandmarkCells(pair.A(), pair.B(), coarse), coarse);
  ASSERT_EQ(result.Maps.AToB.Triangles.size(), mesh.Points.rows());
  const Eigen::MatrixXd wanted = copy.Mesh.Points(copy.NewOf, Eigen::all);
  EXPECT_LT(shapetest::MapErrors(result.Maps.AToB, copy.Mesh, wanted).mean(), 0.02);
  const Eigen::MatrixXd there =
    shape::PullBack(result.Maps.AToB, copy.Mesh.Triangles, copy.Mesh.Points);
  for (const auto& [a, b] : landmarks)
  {
    EXPECT_LT((there.row(a) - copy.Mesh.Points.row(b)).norm(), 1e-12);
  }
}

TEST(ReversibleHarmonic, RefusesOptionsOutOfRange)
{
  const shape::Mesh disk = shapetest::FlatDisk(4);
  const shape::SurfaceMaps start = shape::MapByLandmarkCells(disk, disk, { { 0, 0 } });
  shape::ReversibleHarmonicOptions options;
  options.Alpha = 0.0;
  EXPECT_THROW(
    shape::ComputeReversibleHarmonicMap(disk, disk, start, {}, options), shape::InvalidInput);
}

} // namespace
