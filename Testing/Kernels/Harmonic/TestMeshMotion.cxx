#include "Base/Errors.h"
#include "Harmonic/MeshMotion.h"
#include "Mesh/FaceMesh.h"
#include "Quality/SolidQuality.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace
{

using MethodType = shape::MeshMotionOptions::MethodType;

/// Hexahedra between the unit sphere and a sphere of radius 0.3: `count` layers, thin at the inner
/// one, over the six sides of a cube with count x count squares each.
shape::Cells HollowBall(int count)
{
  shape::Cells cells;
  std::vector<Eigen::RowVector3d> points;
  std::vector<int> corners;
  // Points on the surface of a cube of count^3 cells, projected.
  std::vector<int> number((count + 1) * (count + 1) * (count + 1), -1);
  std::vector<Eigen::RowVector3d> directions;
  const auto at = [&](int i, int j, int k) -> int&
  { return number[i + (count + 1) * (j + (count + 1) * k)]; };
  std::vector<std::array<int, 4>> quads;
  const auto point = [&](const std::array<int, 3>& p)
  {
    int& id = at(p[0], p[1], p[2]);
    if (id < 0)
    {
      id = static_cast<int>(directions.size());
      directions.push_back(
        (2.0 * Eigen::RowVector3d(p[0], p[1], p[2]) / count - Eigen::RowVector3d::Ones())
          .normalized());
    }
    return id;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, count })
    {
      for (int u = 0; u < count; ++u)
      {
        for (int v = 0; v < count; ++v)
        {
          const auto corner = [&](int a, int b)
          {
            std::array<int, 3> p{};
            p[axis] = side;
            p[(axis + 1) % 3] = u + a;
            p[(axis + 2) % 3] = v + b;
            return point(p);
          };
          // Counter-clockwise seen from outside.
          quads.push_back(side == 0
              ? std::array<int, 4>{ corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0) }
              : std::array<int, 4>{ corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1) });
        }
      }
    }
  }
  const auto layer = static_cast<int>(directions.size());
  cells.Points.resize(layer * (count + 1), 3);
  for (int k = 0; k <= count; ++k)
  {
    const double share = static_cast<double>(k) / count;
    for (int i = 0; i < layer; ++i)
    {
      cells.Points.row(layer * k + i) = (0.3 + 0.7 * share * share) * directions[i];
    }
  }
  for (int k = 0; k < count; ++k)
  {
    for (const std::array<int, 4>& quad : quads)
    {
      for (const int level : { k, k + 1 })
      {
        for (const int corner : quad)
        {
          corners.push_back(layer * level + corner);
        }
      }
    }
  }
  cells.Corners = Eigen::Map<const Eigen::VectorXi>(corners.data(), corners.size());
  const auto hexahedra = static_cast<int>(corners.size() / 8);
  cells.Kinds = Eigen::VectorXi::Constant(hexahedra, shape::cell_kind::Hexahedron);
  cells.Offsets = Eigen::VectorXi::LinSpaced(hexahedra + 1, 0, 8 * hexahedra);
  return cells;
}

/// The displacement that turns the inner sphere by an angle and keeps the outer one.
Eigen::MatrixXd TurnInside(const Eigen::MatrixXd& points, double angle)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  Eigen::MatrixXd displacements = points * turn.transpose() - points;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (points.row(i).norm() > 0.5)
    {
      displacements.row(i).setZero();
    }
  }
  return displacements;
}

shape::MeshMotionOptions With(MethodType method, int kernel = 0)
{
  shape::MeshMotionOptions options;
  options.Method = method;
  options.Kernel = static_cast<shape::RadialBasisOptions::KernelType>(kernel);
  return options;
}

const std::vector<shape::MeshMotionOptions>& AllMethods()
{
  static const std::vector<shape::MeshMotionOptions> all = { With(MethodType::Harmonic),
    With(MethodType::RadialBasis), With(MethodType::RadialBasis, 1) };
  return all;
}

} // namespace

TEST(MeshMotion, AffineMotionOfTheBoundaryMovesAllPointsAlike)
{
  const shape::Cells cells = HollowBall(6);
  const Eigen::MatrixXi boundary = shape::TriangulateBoundary(shape::BuildFaceMesh(cells));
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(2.0, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Eigen::Matrix3d shear = turn;
  shear(0, 1) += 0.4;
  for (const Eigen::Matrix3d& linear : { turn, shear })
  {
    const Eigen::MatrixXd moved =
      (cells.Points * linear.transpose()).rowwise() + Eigen::RowVector3d(1, -2, 0.5);
    for (const shape::MeshMotionOptions& options : AllMethods())
    {
      const auto result = shape::MoveMesh(cells.Points, boundary, moved - cells.Points, options);
      EXPECT_LT((result.Points - moved).cwiseAbs().maxCoeff(), 1e-6);
    }
  }
}

TEST(MeshMotion, TurningTheInnerBodyInvertsNoCell)
{
  shape::Cells cells = HollowBall(8);
  const shape::FaceMesh faces = shape::BuildFaceMesh(cells);
  const Eigen::MatrixXi boundary = shape::TriangulateBoundary(faces);
  const Eigen::MatrixXd points = cells.Points;
  const Eigen::MatrixXd displacements = TurnInside(points, 0.35);
  for (const shape::MeshMotionOptions& options : AllMethods())
  {
    const auto result = shape::MoveMesh(points, boundary, displacements, options);
    cells.Points = result.Points;
    EXPECT_EQ(shape::ComputeSolidQuality(cells, faces).Inverted.sum(), 0);
    // The boundary is exact.
    for (const int point : boundary.reshaped())
    {
      EXPECT_EQ(result.Points.row(point), points.row(point) + displacements.row(point));
    }
  }
}

TEST(MeshMotion, HarmonicDisplacementsAreFollowedInside)
{
  // Turning the inner sphere moves a point at the radius r by the harmonic function
  // x (r^-3 - 1) / (0.3^-3 - 1), turned: it is harmonic, 0 on the outer sphere and as given on the
  // inner one.
  const shape::Cells cells = HollowBall(12);
  const Eigen::MatrixXi boundary = shape::TriangulateBoundary(shape::BuildFaceMesh(cells));
  const Eigen::MatrixXd displacements = TurnInside(cells.Points, 0.2);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.2, Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  const auto result = shape::MoveMesh(cells.Points, boundary, displacements);
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    const Eigen::RowVector3d x = cells.Points.row(i);
    const double r = x.norm();
    const double share = (std::pow(r, -3) - 1.0) / (std::pow(0.3, -3) - 1.0);
    const Eigen::RowVector3d expected = x + share * (x * turn.transpose() - x);
    EXPECT_LT((result.Points.row(i) - expected).norm(), 0.05 * 0.2 * 0.3);
  }
}

TEST(MeshMotion, ThinPlatesInterpolateAtAllCentres)
{
  std::srand(5);
  const Eigen::MatrixXd points = shapetest::Icosphere(2).Points;
  const Eigen::MatrixXd values = Eigen::MatrixXd::Random(points.rows(), 3);
  for (const int kernel : { 0, 1 })
  {
    shape::RadialBasisOptions options;
    options.Kernel = static_cast<shape::RadialBasisOptions::KernelType>(kernel);
    options.Tolerance = 0.0;
    options.MaximumCentres = static_cast<int>(points.rows());
    const auto field = shape::FitRadialBasis(points, values, options);
    EXPECT_EQ(field.Centres.rows(), points.rows());
    EXPECT_LT((shape::Evaluate(field, points) - values).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(field.MaximumError, 1e-9);
  }
}

TEST(MeshMotion, MoreCentresLowerTheError)
{
  const Eigen::MatrixXd points = shapetest::Icosphere(4).Points;
  const Eigen::MatrixXd values = (3.0 * points.rowwise().reverse()).array().sin();
  double last = std::numeric_limits<double>::max();
  for (const int count : { 20, 80, 320 })
  {
    shape::RadialBasisOptions options;
    options.Tolerance = 0.0;
    options.MaximumCentres = count;
    const double error = shape::FitRadialBasis(points, values, options).MaximumError;
    EXPECT_LT(error, 0.5 * last);
    last = error;
  }
}

TEST(MeshMotion, OnlyPointsOnTheSurfaceMove)
{
  const shape::Cells cells = HollowBall(4);
  const Eigen::MatrixXi boundary = shape::TriangulateBoundary(shape::BuildFaceMesh(cells));
  // The inner sphere alone, with its own numbers.
  std::vector<Eigen::RowVector3i> inner;
  for (const auto& triangle : boundary.rowwise())
  {
    if (cells.Points.row(triangle(0)).norm() < 0.5)
    {
      inner.emplace_back(triangle);
    }
  }
  Eigen::MatrixXi triangles(inner.size(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    triangles.row(t) = inner[t];
  }
  const shape::Surface surface(cells.Points, triangles);
  const Eigen::MatrixXd images = cells.Points.rowwise() + Eigen::RowVector3d(0.1, 0, 0);
  const shape::BoundaryMotion motion =
    shape::FindBoundaryMotion(cells.Points, boundary, surface, images, 1e-6);
  EXPECT_EQ(motion.Moving, 98);
  EXPECT_EQ(motion.Fixed, 98);
  EXPECT_EQ(motion.Unmatched, 0);
  for (const int point : boundary.reshaped())
  {
    const double expected = cells.Points.row(point).norm() < 0.5 ? 0.1 : 0.0;
    EXPECT_NEAR(motion.Displacements.row(point).norm(), expected, 1e-12);
  }
  const shape::Surface away(
    Eigen::MatrixXd(cells.Points.rowwise() + Eigen::RowVector3d(5, 0, 0)), triangles);
  EXPECT_THROW(
    shape::FindBoundaryMotion(cells.Points, boundary, away, images, 1e-6), shape::InvalidInput);
}
