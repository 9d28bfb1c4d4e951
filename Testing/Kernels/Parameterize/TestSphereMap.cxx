#include "Base/Errors.h"
#include "Parameterize/SphereMap.h"
#include "Parameterize/SphericalTriangles.h"
#include "Support/ProgressChecks.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <cmath>
#include <fstream>

namespace
{

shape::Mesh Ellipsoid(int level, double x, double y, double z)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  mesh.Points *= Eigen::Vector3d(x, y, z).asDiagonal();
  return mesh;
}

/// A sphere with dents and bumps, of no symmetry.
shape::Mesh Bumpy(int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const Eigen::RowVector3d p = mesh.Points.row(i);
    mesh.Points.row(i) *= 1.0 + 0.35 * std::sin(6.0 * p(0) + 1.0) * std::cos(5.0 * p(1)) +
      0.2 * std::sin(4.0 * p(2) + p(0));
  }
  return mesh;
}

/// A box whose edges cut through triangles.
shape::Mesh Box(int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    mesh.Points.row(i) /= mesh.Points.row(i).cwiseAbs().maxCoeff();
  }
  mesh.Points.col(2) *= 3.0;
  return mesh;
}

/// A cylinder between two poles with needles a hundred times as long as wide.
shape::Mesh Needles(int around, int across)
{
  const int n = around * across + 2;
  shape::Mesh mesh{ Eigen::MatrixXd(n, 3), Eigen::MatrixXi(2 * around * across, 3) };
  mesh.Points.row(n - 2) << 0.0, 0.0, -3.0;
  mesh.Points.row(n - 1) << 0.0, 0.0, 3.0;
  int t = 0;
  for (int i = 0; i < around; ++i)
  {
    const int right = (i + 1) % around;
    for (int j = 0; j < across; ++j)
    {
      const double angle = 2.0 * M_PI * i / around;
      mesh.Points.row(i * across + j) << std::cos(angle), std::sin(angle),
        -2.0 + 4.0 * j / (across - 1);
      if (j + 1 < across)
      {
        mesh.Triangles.row(t++) << i * across + j, right * across + j, right * across + j + 1;
        mesh.Triangles.row(t++) << i * across + j, right * across + j + 1, i * across + j + 1;
      }
    }
    mesh.Triangles.row(t++) << i * across, n - 2, right * across;
    mesh.Triangles.row(t++) << i * across + across - 1, right * across + across - 1, n - 1;
  }
  return mesh;
}

/// A sphere moved in itself by an inversion: its triangles differ a hundredfold in size.
shape::Mesh MoebiusSphere(int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  const Eigen::RowVector3d center(0.5, 0.2, -0.3);
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const Eigen::RowVector3d sum = mesh.Points.row(i) + center;
    mesh.Points.row(i) = (1.0 - center.squaredNorm()) / sum.squaredNorm() * sum + center;
  }
  return mesh;
}

Eigen::Matrix3d SomeRotation()
{
  return Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
}

/// The largest distance between two point sets after the best rotation.
double DistanceUpToRotation(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  const Eigen::Matrix3d product = a.transpose() * b;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d sign = Eigen::Matrix3d::Identity();
  sign(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
  return (a * svd.matrixU() * sign * svd.matrixV().transpose() - b).rowwise().norm().maxCoeff();
}

Eigen::RowVector3d MeanOf(const shape::Mesh& mesh, const Eigen::MatrixXd& image)
{
  const Eigen::VectorXd areas = shape::ComputePointAreas(mesh);
  return areas.transpose() * image / areas.sum();
}

void ExpectOneToOneAndCentred(const shape::Mesh& mesh, const shape::SphereMapResult& map)
{
  EXPECT_TRUE(shape::FindFlippedTriangles(mesh.Triangles, map.Points).empty());
  EXPECT_NEAR(shape::ComputeSolidAngles(mesh.Triangles, map.Points).sum(), 4.0 * M_PI, 1e-9);
  EXPECT_LT((map.Points.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
  EXPECT_LT(MeanOf(mesh, map.Points).norm(), 1e-9);
  EXPECT_GT(map.SmallestArea, 0.0);
}

} // namespace

TEST(SphereMap, GeneratedShapesMapOneToOneToTheUnitSphere)
{
  for (const shape::Mesh& mesh : { Ellipsoid(4, 4.0, 1.0, 0.5), Bumpy(4), Box(4), Needles(300, 4),
         Ellipsoid(3, 1.0, 1.0, 0.01), shapetest::Icosphere(0) })
  {
    ExpectOneToOneAndCentred(mesh, shape::MapToSphere(mesh));
  }
}

TEST(SphereMap, EachMethodMapsOneToOne)
{
  const shape::Mesh mesh = Bumpy(4);
  for (const shape::SphereMapMethod method : { shape::SphereMapMethod::ConformalFlow,
         shape::SphereMapMethod::PositiveFlow, shape::SphereMapMethod::GlobalReinsertion })
  {
    shape::SphereMapOptions options;
    options.First = method;
    const shape::SphereMapResult map = shape::MapToSphere(mesh, options);
    EXPECT_EQ(map.Method, method);
    ExpectOneToOneAndCentred(mesh, map);
  }
}

TEST(SphereMap, GlobalReinsertionBalancesTheAreasOfALongTube)
{
  // The conformal image of a tube shrinks from its middle to its ends like exp(-z / radius).
  shape::Mesh tube = Needles(12, 40);
  tube.Points.col(2) *= 4.0;
  const shape::SphereMapResult conformal = shape::MapToSphere(tube);
  ASSERT_EQ(conformal.Method, shape::SphereMapMethod::ConformalFlow);
  EXPECT_LT(conformal.SmallestArea, 1e-5);
  shape::SphereMapOptions options;
  options.First = shape::SphereMapMethod::GlobalReinsertion;
  double smallest = conformal.SmallestArea;
  for (const double weight : { 1.0, 10.0 })
  {
    options.AreaWeight = weight;
    const shape::SphereMapResult map = shape::MapToSphere(tube, options);
    ExpectOneToOneAndCentred(tube, map);
    EXPECT_GT(map.SmallestArea, 5.0 * smallest) << weight;
    smallest = map.SmallestArea;
  }
  EXPECT_GT(smallest, 0.02 * 4.0 * M_PI / tube.Triangles.rows());
}

TEST(SphereMap, ASphereMapsToItselfUpToRotationAndTheErrorFallsWithTheMesh)
{
  const shape::Mesh coarse = MoebiusSphere(3), fine = MoebiusSphere(4);
  const double coarseError = DistanceUpToRotation(coarse.Points, shape::MapToSphere(coarse).Points);
  const double fineError = DistanceUpToRotation(fine.Points, shape::MapToSphere(fine).Points);
  EXPECT_LT(fineError, 0.02);
  EXPECT_LT(fineError, 0.5 * coarseError);
}

TEST(SphereMap, AnglesAreKeptBetterOnFinerMeshes)
{
  double errors[2];
  for (int i = 0; i < 2; ++i)
  {
    const shape::Mesh mesh = Bumpy(3 + i);
    const shape::Mesh image{ shape::MapToSphere(mesh).Points, mesh.Triangles };
    double sum = 0.0;
    for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const auto angleOf = [&](const shape::Mesh& in)
        {
          const Eigen::RowVector3d a = in.Points.row(in.Triangles(t, corner));
          const Eigen::RowVector3d u = in.Points.row(in.Triangles(t, (corner + 1) % 3)) - a;
          const Eigen::RowVector3d v = in.Points.row(in.Triangles(t, (corner + 2) % 3)) - a;
          return std::atan2(u.cross(v).norm(), u.dot(v));
        };
        sum += std::abs(angleOf(mesh) - angleOf(image));
      }
    }
    errors[i] = sum / (3.0 * mesh.Triangles.rows());
  }
  EXPECT_LT(errors[1], 0.05);
  EXPECT_LT(errors[1], 0.7 * errors[0]);
}

TEST(SphereMap, MovesAndTurnsWithTheInputAtAnyScale)
{
  const shape::Mesh mesh = Bumpy(3);
  const Eigen::MatrixXd image = shape::MapToSphere(mesh).Points;
  const Eigen::Matrix3d rotation = SomeRotation();
  shape::Mesh turned = mesh;
  turned.Points *= rotation;
  EXPECT_LT((shape::MapToSphere(turned).Points - image * rotation).cwiseAbs().maxCoeff(), 1e-9);
  for (const double scale : { 1e-6, 1e6 })
  {
    shape::Mesh scaled = mesh;
    scaled.Points *= scale;
    EXPECT_LT((shape::MapToSphere(scaled).Points - image).cwiseAbs().maxCoeff(), 1e-9);
  }
  shape::Mesh far = mesh;
  far.Points.rowwise() += Eigen::RowVector3d(1e6, -2e6, 3e6);
  EXPECT_LT((shape::MapToSphere(far).Points - image).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(SphereMap, ASurfaceThatFacesInwardsIsMirrored)
{
  shape::Mesh mesh = Bumpy(3);
  mesh.Triangles.col(0).swap(mesh.Triangles.col(1));
  ASSERT_LT(shape::ComputeEnclosedVolume(mesh), 0.0);
  ExpectOneToOneAndCentred(mesh, shape::MapToSphere(mesh));
}

TEST(SphereMap, PointsAtOnePlaceAndTrianglesWithoutAreaGetAreaOnTheSphere)
{
  shape::Mesh mesh = Bumpy(3);
  for (const int t : { 5, 200, 611 })
  {
    mesh.Points.row(mesh.Triangles(t, 1)) = mesh.Points.row(mesh.Triangles(t, 0));
  }
  const Eigen::RowVector3i flat = mesh.Triangles.row(900);
  mesh.Points.row(flat(2)) = 0.5 * (mesh.Points.row(flat(0)) + mesh.Points.row(flat(1)));
  ExpectOneToOneAndCentred(mesh, shape::MapToSphere(mesh));
}

TEST(SphereMap, FoldedTrianglesThatFlipAreMendedWhereTheyAre)
{
  shape::Mesh mesh = Bumpy(3);
  for (const int t : { 100, 700, 1000 })
  {
    const Eigen::RowVector3d other = mesh.Points.row(mesh.Triangles(t, 1));
    const Eigen::RowVector3d own = mesh.Points.row(mesh.Triangles(t, 0));
    mesh.Points.row(mesh.Triangles(t, 0)) = own + 1.6 * (other - own);
  }
  const shape::SphereMapResult map = shape::MapToSphere(mesh);
  ExpectOneToOneAndCentred(mesh, map);
  EXPECT_EQ(map.Method, shape::SphereMapMethod::ConformalFlow);
  EXPECT_GT(map.FlipsBeforeRelaxation, 0);
  EXPECT_GT(map.Reinserted, 0);
  EXPECT_LT(map.Reinserted, 30);
}

TEST(SphereMap, GivesTheSameBitsTwice)
{
  const shape::Mesh mesh = Ellipsoid(4, 3.0, 1.0, 0.2);
  EXPECT_EQ(shape::MapToSphere(mesh).Points, shape::MapToSphere(mesh).Points);
}

TEST(SphereMap, RefusesWhatIsNoSphereAndSaysWhy)
{
  EXPECT_REFUSED(
    shape::MapToSphere(shapetest::Torus(1.0, 0.3, 20, 10)), "Euler number 0 (genus 1)");

  const shape::Mesh one = shapetest::Icosphere(1);
  EXPECT_REFUSED(shape::MapToSphere(shapetest::Twice(one)), "2 components");

  const Eigen::Index n = one.Points.rows();
  shape::Mesh unused = one;
  unused.Points.conservativeResize(n + 2, 3);
  unused.Points.bottomRows(2).setZero();
  EXPECT_REFUSED(shape::MapToSphere(unused),
    "2 points that no triangle uses (first at point " + std::to_string(n) + ")");

  shape::SphereMapOptions options;
  options.MaximumIterations = 0;
  EXPECT_THROW(shape::MapToSphere(one, options), shape::InvalidInput);

  shape::Mesh point = one;
  point.Points.setConstant(7.0);
  EXPECT_REFUSED(shape::MapToSphere(point), "no area");
}

TEST(SphereMap, ProgressRisesAndCanStop)
{
  const shape::Mesh mesh = Bumpy(3);
  const auto call = [&](const shape::Progress& progress)
  { shape::MapToSphere(mesh, {}, progress); };
  EXPECT_GT(shapetest::ExpectProgressRises(call), 5);
  shapetest::ExpectStopsAt(4, call);
}

TEST(SphereMap, ScannedModelsMapOneToOne)
{
  const std::string folder = SHAPEMAP_MODELS;
  if (!std::ifstream(folder + "/man.off"))
  {
    GTEST_SKIP() << "no models in " << folder;
  }
  for (const char* name : { "bear", "bear_bis", "bunny00", "armadillo", "man" })
  {
    const shape::Mesh mesh = shapetest::ReadOff(folder + "/" + name + ".off");
    const shape::SphereMapResult map = shape::MapToSphere(mesh);
    ExpectOneToOneAndCentred(mesh, map);
    EXPECT_EQ(map.Method, shape::SphereMapMethod::ConformalFlow) << name;
  }
  EXPECT_REFUSED(
    shape::MapToSphere(shapetest::ReadOff(folder + "/elephant.off")), "Euler number -4 (genus 3)");
}
