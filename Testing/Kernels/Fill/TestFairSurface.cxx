#include "Fill/FairSurface.h"
#include "Fill/HolePatch.h"
#include "Fill/Private/HoleDisk.h"
#include "Geometry/VertexNormals.h"
#include "Laplacian/Membrane.h"
#include "Mesh/Topology.h"
#include "Support/HoleShapes.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{

using shapetest::Degree;

/// The flat disk of so many rings, its outer ring first, in order.
shape::Mesh DiskLoopFirst(int rings, int& loop)
{
  const shape::Mesh disk = shapetest::FlatDisk(rings);
  loop = 6 * rings;
  const auto first = static_cast<int>(disk.Points.rows()) - loop;
  shape::Mesh turned{ Eigen::MatrixXd(disk.Points.rows(), 3), disk.Triangles };
  turned.Points << disk.Points.bottomRows(loop), disk.Points.topRows(first);
  for (int& corner : turned.Triangles.reshaped())
  {
    corner = corner >= first ? corner - first : corner + loop;
  }
  return turned;
}

/// Inner points of a disk moved within it, so that no two rings of triangles are alike.
void Shake(shape::Mesh& disk, int loop, double size)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-size, size);
  for (Eigen::Index i = loop; i < disk.Points.rows(); ++i)
  {
    disk.Points(i, 0) += shift(random);
    disk.Points(i, 1) += shift(random);
  }
}

/// The circle at an angle from the pole of the unit sphere, and the sphere's normals there.
shape::BoundaryLoop CircleOfSphere(const shape::Mesh& disk, int loop, double angle)
{
  shape::BoundaryLoop circle;
  circle.Points = std::sin(angle) * disk.Points.topRows(loop);
  circle.Points.col(2).setConstant(std::cos(angle));
  circle.Normals = circle.Points;
  return circle;
}

double Roundness(const Eigen::MatrixXd& points)
{
  return (points.rowwise().norm().array() - 1.0).abs().maxCoeff();
}

} // namespace

TEST(FairSurface, OfARimOnASphereIsTheSphere)
{
  int loop = 0;
  shape::Mesh disk = DiskLoopFirst(12, loop);
  Shake(disk, loop, 0.03);
  for (const double degrees : { 20.0, 70.0, 110.0 })
  {
    const shape::BoundaryLoop circle = CircleOfSphere(disk, loop, degrees * Degree);
    shape::Mesh start{ shape::SolveBiharmonicSurface(disk, circle), disk.Triangles };
    const double before = Roundness(start.Points);
    const shape::FairSurfaceResult fair =
      shape::SolveFairSurface(start, circle.Normals, { 20, 1e-6 });
    EXPECT_TRUE(fair.Converged);
    EXPECT_LT(Roundness(fair.Points), degrees < 100.0 ? 1e-3 : 1e-2);
    EXPECT_LT(Roundness(fair.Points), 0.2 * before);
    EXPECT_EQ(fair.Points.topRows(loop), circle.Points);
  }
}

TEST(FairSurface, OfPointsOnASphereIsThese)
{
  // Whatever the triangles, as long as they are Delaunay: then the mean curvature is exact.
  int loop = 0;
  shape::Mesh cap = DiskLoopFirst(8, loop);
  for (auto point : cap.Points.rowwise())
  {
    const double angle = point.norm();
    point = Eigen::RowVector3d(angle > 0.0 ? std::sin(angle) / angle * point.x() : 0.0,
      angle > 0.0 ? std::sin(angle) / angle * point.y() : 0.0, std::cos(angle));
  }
  const shape::FairSurfaceResult fair =
    shape::SolveFairSurface(cap, cap.Points.topRows(loop), { 5, 1e-6 });
  EXPECT_TRUE(fair.Converged);
  EXPECT_EQ(fair.Iterations, 1);
  EXPECT_LT((fair.Points - cap.Points).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(FairSurface, OfARimOnACylinderIsTheCylinder)
{
  int loop = 0;
  const shape::Mesh disk = DiskLoopFirst(14, loop);
  shape::BoundaryLoop curve;
  curve.Points.resize(loop, 3);
  curve.Normals.resize(loop, 3);
  for (int i = 0; i < loop; ++i)
  {
    const double angle = disk.Points(i, 0); // a radian around, as much along
    curve.Points.row(i) << std::sin(angle), disk.Points(i, 1), std::cos(angle);
    curve.Normals.row(i) << std::sin(angle), 0.0, std::cos(angle);
  }
  shape::Mesh start{ shape::SolveBiharmonicSurface(disk, curve), disk.Triangles };
  const shape::FairSurfaceResult fair = shape::SolveFairSurface(start, curve.Normals, { 20, 1e-6 });
  EXPECT_TRUE(fair.Converged);
  Eigen::MatrixXd across = fair.Points;
  across.col(1).setZero();
  EXPECT_LT(Roundness(across), 3e-3);
}

TEST(FairSurface, OfAPlaneIsThePlane)
{
  int loop = 0;
  shape::Mesh disk = DiskLoopFirst(6, loop);
  Shake(disk, loop, 0.02);
  Eigen::MatrixXd up = Eigen::MatrixXd::Zero(loop, 3);
  up.col(2).setOnes();
  const shape::BoundaryLoop circle{ disk.Points.topRows(loop), up };
  shape::Mesh start{ shape::SolveBiharmonicSurface(disk, circle), disk.Triangles };
  const shape::FairSurfaceResult fair = shape::SolveFairSurface(start, up);
  EXPECT_TRUE(fair.Converged);
  EXPECT_EQ(fair.Points.col(2).cwiseAbs().maxCoeff(), 0.0);
}

TEST(FairSurface, TurnsWithItsRim)
{
  int loop = 0;
  const shape::Mesh disk = DiskLoopFirst(8, loop);
  shape::BoundaryLoop curve = CircleOfSphere(disk, loop, 1.0);
  for (int i = 0; i < loop; ++i)
  {
    curve.Points(i, 2) += 0.2 * std::cos(2.0 * M_PI * 3.0 * i / loop);
  }
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.3, Eigen::Vector3d(1, 2, -3).normalized()).toRotationMatrix();
  const Eigen::RowVector3d shift(4.0, -2.0, 7.0);
  const shape::BoundaryLoop moved{ (curve.Points * turn.transpose()).rowwise() + shift,
    curve.Normals * turn.transpose() };
  const auto fair = [&](const shape::BoundaryLoop& loopOf)
  {
    shape::Mesh start{ shape::SolveBiharmonicSurface(disk, loopOf), disk.Triangles };
    return shape::SolveFairSurface(start, loopOf.Normals).Points;
  };
  const Eigen::MatrixXd wanted = (fair(curve) * turn.transpose()).rowwise() + shift;
  EXPECT_LT((fair(moved) - wanted).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(Membrane, IsFlatOverAFlatRimAndTautOverABentOne)
{
  int loop = 0;
  const shape::Mesh disk = DiskLoopFirst(8, loop);
  Eigen::MatrixXd tilted = disk.Points.topRows(loop);
  tilted.col(2) = 0.5 * tilted.col(0) - 0.25 * tilted.col(1);
  const Eigen::MatrixXd points = shape::SolveMembrane(disk, tilted, 3);
  const Eigen::VectorXd off = points.col(2) - 0.5 * points.col(0) + 0.25 * points.col(1);
  EXPECT_LT(off.cwiseAbs().maxCoeff(), 1e-12);

  // Of a bent rim it has less area than the harmonic map of the disk, and no other stationary one
  // is near: more rounds change it little.
  Eigen::MatrixXd bent = disk.Points.topRows(loop);
  bent.col(2) = bent.col(0).cwiseProduct(bent.col(1));
  const auto area = [&](int rounds)
  {
    const shape::Mesh mesh{ shape::SolveMembrane(disk, bent, rounds), disk.Triangles };
    return 0.5 * shape::ComputeAreaVectors(mesh).rowwise().norm().sum();
  };
  EXPECT_LT(area(3), area(0));
  EXPECT_NEAR(area(20), area(3), 1e-3 * area(3));
}

TEST(Membrane, ValuesStayBetweenThoseOfTheRim)
{
  int loop = 0;
  shape::Mesh disk = DiskLoopFirst(10, loop);
  Shake(disk, loop, 0.04);
  Eigen::MatrixXd values(loop, 2);
  for (int i = 0; i < loop; ++i)
  {
    values.row(i) << (i % 2 == 0 ? 1.0 : -1.0), disk.Points(i, 0);
  }
  const Eigen::MatrixXd inside = shape::SolveHarmonicValues(disk, values);
  EXPECT_LT(inside.col(0).tail(disk.Points.rows() - loop).cwiseAbs().maxCoeff(), 1.0);
  EXPECT_EQ(inside.topRows(loop), values);
  // Linear values are harmonic.
  EXPECT_LT((inside.col(1) - disk.Points.col(0)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(HoleDisk, TheCircleKeepsLengths)
{
  const auto lengthsOf = [](const Eigen::MatrixXd& outline)
  {
    Eigen::VectorXd lengths(outline.rows());
    for (Eigen::Index i = 0; i < outline.rows(); ++i)
    {
      lengths(i) = (outline.row((i + 1) % outline.rows()) - outline.row(i)).norm();
    }
    return lengths;
  };
  Eigen::VectorXd lengths(7);
  lengths << 1.0, 2.0, 0.5, 1.5, 1.0, 0.7, 2.5;
  const Eigen::MatrixXd outline = shape::BuildCircleOutline(lengths);
  EXPECT_LT((lengthsOf(outline) - lengths).cwiseAbs().maxCoeff(), 1e-12);
  const Eigen::VectorXd radii = outline.rowwise().norm();
  EXPECT_LT((radii.array() - radii.mean()).abs().maxCoeff(), 1e-12);
  // The centre lies outside of an obtuse triangle, whose sides are kept all the same.
  Eigen::Vector3d obtuse(3.0, 4.0, 6.9);
  EXPECT_LT((lengthsOf(shape::BuildCircleOutline(obtuse)) - obtuse).cwiseAbs().maxCoeff(), 1e-9);
  // What does not close is shortened; what has no length gets some.
  Eigen::Vector4d impossible(1.0, 0.0, 1.0, 9.0);
  const Eigen::VectorXd made = lengthsOf(shape::BuildCircleOutline(impossible));
  EXPECT_GT(made.minCoeff(), 1e-4);
  EXPECT_TRUE(made.allFinite());
}

TEST(HoleDisk, TrianglesAreEvenAndFillTheOutline)
{
  Eigen::MatrixXd outline = shape::BuildCircleOutline(Eigen::VectorXd::Ones(80));
  shape::FlatDiskOptions options;
  options.Edge = 1.0;
  options.Size = [](const Eigen::RowVector2d&) { return 1.0; };
  const shape::FlatDisk disk = shape::TriangulateDisk(outline, options);
  EXPECT_EQ(disk.Points.topRows(80), outline);
  shape::Mesh mesh{ Eigen::MatrixXd::Zero(disk.Points.rows(), 3), disk.Triangles };
  mesh.Points.leftCols<2>() = disk.Points;
  const shape::Topology topology = shape::ComputeTopology(mesh);
  EXPECT_EQ(topology.EulerNumber, 1);
  EXPECT_EQ(topology.BoundaryLoops, 1);
  const Eigen::MatrixXd normals = shape::ComputeAreaVectors(mesh);
  EXPECT_GT(normals.col(2).minCoeff(), 0.1); // twice the area; 0.87 where they are equilateral
  double area = 0.0;
  for (int i = 0; i < 80; ++i)
  {
    const Eigen::RowVector2d a = outline.row(i), b = outline.row((i + 1) % 80);
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_NEAR(0.5 * normals.col(2).sum(), area, 1e-9 * area);
  // Twice as long in the middle: about a quarter of the triangles there.
  options.Size = [](const Eigen::RowVector2d& p) { return p.norm() < 6.0 ? 2.0 : 1.0; };
  EXPECT_LT(shape::TriangulateDisk(outline, options).Triangles.rows(),
    disk.Triangles.rows() - 0.5 * 36.0 * M_PI / std::sqrt(0.1875) * 0.5);
  // An edge between two corners that must not be there is not.
  Eigen::MatrixXd square(4, 2);
  square << 0, 0, 1, 0, 1, 1, 0, 1;
  options.Size = [](const Eigen::RowVector2d&) { return 1.0; };
  EXPECT_EQ(shape::TriangulateDisk(square, options).Triangles.rows(), 2);
  options.IsTaken = [](int, int) { return true; };
  EXPECT_EQ(shape::TriangulateDisk(square, options).Triangles.rows(), 4);
}

TEST(RimNormals, AreThoseOfTheSphereAtItsBorder)
{
  shape::Mesh sphere = shapetest::Icosphere(4);
  int kept = 0;
  for (int t = 0; t < sphere.Triangles.rows(); ++t)
  {
    if (shape::GetCorners(sphere, t).col(2).mean() < 0.5)
    {
      sphere.Triangles.row(kept++) = sphere.Triangles.row(t);
    }
  }
  sphere.Triangles.conservativeResize(kept, 3);
  std::vector<int> boundary;
  for (int i = 0; i < sphere.Points.rows(); ++i)
  {
    if (sphere.Points(i, 2) > 0.4 && sphere.Points(i, 2) < 0.5)
    {
      boundary.push_back(i);
    }
  }
  const shape::TriangleFans fans(sphere.Triangles, sphere.Points.rows());
  const Eigen::MatrixXd normals = shape::ComputeBoundaryNormals(sphere, fans, boundary);
  double worst = 0.0;
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    const Eigen::RowVector3d normal = normals.row(i), wanted = sphere.Points.row(boundary[i]);
    worst = std::max(worst, std::acos(std::min(1.0, normal.dot(wanted))) / Degree);
  }
  EXPECT_GT(boundary.size(), 50u);
  EXPECT_LT(worst, 0.1); // means of the triangles are off by more than a degree
}
