#include "Base/Errors.h"
#include "Correspondence/Conformal/BlendedIntrinsic.h"
#include "Correspondence/Conformal/Private/MoebiusMap.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

shape::Mesh Model(const std::string& name)
{
  return shapetest::ReadOff(std::string(SHAPEMAP_MODELS) + "/" + name + ".off");
}

/// The surface without the triangles of some of its points, and without those points.
shape::Mesh Without(const shape::Mesh& mesh, const Eigen::Array<bool, Eigen::Dynamic, 1>& cut)
{
  std::vector<int> kept, points;
  Eigen::VectorXi position = Eigen::VectorXi::Constant(mesh.Points.rows(), -1);
  for (int t = 0; t < static_cast<int>(mesh.Triangles.rows()); ++t)
  {
    const auto corners = mesh.Triangles.row(t);
    if (!cut(corners(0)) && !cut(corners(1)) && !cut(corners(2)))
    {
      kept.push_back(t);
      for (const int corner : corners)
      {
        if (position(corner) < 0)
        {
          position(corner) = static_cast<int>(points.size());
          points.push_back(corner);
        }
      }
    }
  }
  return { mesh.Points(points, Eigen::all),
    mesh.Triangles(kept, Eigen::all).unaryExpr([&](int i) { return position(i); }) };
}

} // namespace

TEST(BlendedIntrinsic, ComplexPointsKeepThePlacesOfTheSphere)
{
  const Eigen::MatrixXd sphere = shapetest::Icosphere(3).Points;
  EXPECT_LT(
    (shape::ToSphere(shape::ToComplexPoints(sphere)) - sphere).cwiseAbs().maxCoeff(), 1e-14);
  Eigen::MatrixXd poles(4, 3);
  poles << 0, 0, 1, 0, 0, -1, 1e-12, 0, 1, 0, 1e-12, -1;
  EXPECT_LT((shape::ToSphere(shape::ToComplexPoints(poles)) - poles).cwiseAbs().maxCoeff(), 1e-20);
}

TEST(BlendedIntrinsic, ThreePointsMakeTheMoebiusMap)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const shape::ComplexPoints points = shape::ToComplexPoints(sphere.Points);
  const auto through = [&](int a, int b, int c, int d, int e, int f)
  {
    return shape::SolveMoebiusTransform(
      points(Eigen::Vector3i(a, b, c), Eigen::all), points(Eigen::Vector3i(d, e, f), Eigen::all));
  };
  // To themselves: the identity.
  EXPECT_LT(
    (shape::ToSphere(shape::ApplyMoebiusTransform(points, through(3, 70, 500, 3, 70, 500))) -
      sphere.Points)
      .cwiseAbs()
      .maxCoeff(),
    1e-12);
  // To others: they arrive, there and back is the identity, and both are one map after the other.
  const Eigen::Matrix2cd there = through(3, 70, 500, 8, 900, 41);
  const Eigen::MatrixXd moved = shape::ToSphere(shape::ApplyMoebiusTransform(points, there));
  EXPECT_LT((moved.row(3) - sphere.Points.row(8)).norm(), 1e-12);
  EXPECT_LT((moved.row(70) - sphere.Points.row(900)).norm(), 1e-12);
  EXPECT_LT((moved.row(500) - sphere.Points.row(41)).norm(), 1e-12);
  const Eigen::Matrix2cd both = through(8, 900, 41, 3, 70, 500) * there;
  EXPECT_LT((shape::ToSphere(shape::ApplyMoebiusTransform(points, both)) - sphere.Points)
              .cwiseAbs()
              .maxCoeff(),
    1e-11);
  // Nothing is turned over, and areas grow as is said.
  const Eigen::VectorXd scales = shape::ComputeLogAreaScales(points, there);
  double worst = 0.0;
  for (Eigen::Index t = 0; t < sphere.Triangles.rows(); ++t)
  {
    const Eigen::Vector3i corners = sphere.Triangles.row(t);
    const Eigen::Matrix3d before = sphere.Points(corners, Eigen::all),
                          after = moved(corners, Eigen::all);
    EXPECT_GT(after.determinant(), 0.0);
    const shape::Mesh one{ before, Eigen::RowVector3i(0, 1, 2) },
      other{ after, Eigen::RowVector3i(0, 1, 2) };
    const double grown =
      std::log(shape::ComputeAreaVectors(other).norm() / shape::ComputeAreaVectors(one).norm());
    worst = std::max(worst, std::abs(grown - scales(corners).mean()));
  }
  EXPECT_LT(worst, 0.05);
  EXPECT_FALSE(through(3, 3, 500, 8, 900, 41).allFinite()); // two are the same
}

TEST(BlendedIntrinsic, ACopyIsMappedOntoItself)
{
  const shape::Mesh a = Model("bull");
  const shapetest::Renumbered copy = shapetest::Renumber(a, 4);
  shape::Mesh b = copy.Mesh;
  const Eigen::Matrix3d turn = shapetest::Rotation(2.0, { 1, 2, 3 });
  b.Points = 2.0 * b.Points * turn.transpose();
  const Eigen::MatrixXd wanted = 2.0 * a.Points * turn.transpose();
  // No landmark says which side is which.
  const shape::SurfaceMaps maps = shape::ComputeBlendedIntrinsicMap(a, b, {});
  EXPECT_LT(shapetest::MapErrors(maps.AToB, b, wanted).mean(), 0.005);
  Eigen::MatrixXd back(b.Points.rows(), 3);
  back(copy.NewOf, Eigen::all) = a.Points;
  EXPECT_LT(shapetest::MapErrors(maps.BToA, a, back).mean(), 0.005);
}

TEST(BlendedIntrinsic, FindsTheSameSurfaceInOtherTrianglesAlsoWithHoles)
{
  shape::Mesh a = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  shape::Mesh b = shapetest::BumpySphere(4, shapetest::Rotation(0.7, { 3, -1, 1 }));
  for (const bool hasHole : { false, true })
  {
    if (hasHole)
    {
      const auto isCut = [](const shape::Mesh& mesh)
      {
        return (mesh.Points.rowwise() - Eigen::RowVector3d(-0.8, 0.2, -0.5))
                 .rowwise()
                 .norm()
                 .array() < 0.4;
      };
      a = Without(a, isCut(a));
      b = Without(b, isCut(b));
    }
    shape::Landmarks landmarks;
    for (const Eigen::RowVector3d& tip : { Eigen::RowVector3d(2.4, 0, 0),
           Eigen::RowVector3d(-0.85, 1.9, 0), Eigen::RowVector3d(0.23, -1.16, -1.85) })
    {
      Eigen::Index i = 0, j = 0;
      (a.Points.rowwise() - tip).rowwise().norm().minCoeff(&i);
      (b.Points.rowwise() - tip).rowwise().norm().minCoeff(&j);
      landmarks.push_back({ static_cast<int>(i), static_cast<int>(j) });
    }
    const shape::SurfaceMaps maps = shape::ComputeBlendedIntrinsicMap(a, b, landmarks);
    EXPECT_LT(shapetest::MapErrors(maps.AToB, b, a.Points).mean(), 0.02) << hasHole;
    EXPECT_LT(shapetest::MapErrors(maps.BToA, a, b.Points).mean(), 0.02) << hasHole;
    // One wrong landmark does not spoil what others agree on.
    Eigen::Index tip = 0;
    (a.Points.rowwise() - Eigen::RowVector3d(-0.95, -1.15, 1.15)).rowwise().norm().minCoeff(&tip);
    Eigen::Index tipB = 0;
    (b.Points.rowwise() - a.Points.row(tip)).rowwise().norm().minCoeff(&tipB);
    landmarks.push_back({ static_cast<int>(tip), static_cast<int>(tipB) });
    Eigen::Index top = 0, bottom = 0;
    (a.Points.rowwise() - Eigen::RowVector3d(0.35, 0.5, 1.6)).rowwise().norm().minCoeff(&top);
    (b.Points.rowwise() - Eigen::RowVector3d(0.0, 0.7, -0.8)).rowwise().norm().minCoeff(&bottom);
    landmarks.push_back({ static_cast<int>(top), static_cast<int>(bottom) });
    const shape::SurfaceMaps voted = shape::ComputeBlendedIntrinsicMap(a, b, landmarks);
    EXPECT_LT(shapetest::MapErrors(voted.AToB, b, a.Points).mean(), 0.04) << hasHole;
  }
}

TEST(BlendedIntrinsic, TheOrderOfPointsDoesNotChangeTheMapOfASheet)
{
  shape::Mesh sheet = shapetest::FlatDisk(8);
  for (Eigen::Index i = 0; i < sheet.Points.rows(); ++i)
  {
    const double x = sheet.Points(i, 0), y = sheet.Points(i, 1);
    sheet.Points.row(i) << 1.4 * x, y, 0.3 * x * x + 0.2 * x * y + 0.1 * y;
  }
  for (unsigned int seed = 0; seed < 6; ++seed)
  {
    const shapetest::Renumbered copy = shapetest::Renumber(sheet, seed);
    shape::Landmarks landmarks;
    for (int i = 0; i < static_cast<int>(sheet.Points.rows()); i += 37)
    {
      landmarks.push_back({ i, copy.NewOf(i) });
    }
    const shape::SurfaceMaps maps = shape::ComputeBlendedIntrinsicMap(sheet, copy.Mesh, landmarks);
    EXPECT_LT(shapetest::MapErrors(maps.AToB, copy.Mesh, sheet.Points).mean(), 1e-6) << seed;
  }
}

TEST(BlendedIntrinsic, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 24, 12);
  EXPECT_REFUSED(shape::ComputeBlendedIntrinsicMap(sphere, torus, {}), "surface B has genus 1");
  EXPECT_REFUSED(shape::ComputeBlendedIntrinsicMap(torus, sphere, {}), "surface A has genus 1");
  EXPECT_REFUSED(
    shape::ComputeBlendedIntrinsicMap(sphere, sphere, { { 0, 0 }, { 9, 9 } }), "2 landmarks");
  EXPECT_REFUSED(
    shape::ComputeBlendedIntrinsicMap(sphere, sphere, { { 0, 0 }, { 0, 9 }, { 0, 7 } }),
    "no three");
  EXPECT_REFUSED(
    shape::ComputeBlendedIntrinsicMap(sphere, sphere, { { 0, 0 }, { 9, 9 }, { 9999, 7 } }), "9999");
  EXPECT_REFUSED(
    shape::ComputeBlendedIntrinsicMap(shapetest::Twice(sphere), sphere, {}), "2 components");
}
