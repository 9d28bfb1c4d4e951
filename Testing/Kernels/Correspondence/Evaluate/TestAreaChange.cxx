#include "Correspondence/Evaluate/AreaChange.h"
#include "Correspondence/Pair/ReversedArea.h"
#include "Support/MatchingShapes.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

const double Pi = std::acos(-1.0);

/// A thin strip from x = 0 to 1, whose columns of points are at along(k / columns).
template <typename Along>
shape::Mesh Strip(int columns, double height, const Along& along)
{
  shape::Mesh strip{ Eigen::MatrixXd(2 * (columns + 1), 3), Eigen::MatrixXi(2 * columns, 3) };
  for (int k = 0; k <= columns; ++k)
  {
    const double x = along(static_cast<double>(k) / columns);
    strip.Points.row(2 * k) << x, 0.0, 0.0;
    strip.Points.row(2 * k + 1) << x, height, 0.0;
  }
  for (int k = 0; k < columns; ++k)
  {
    strip.Triangles.row(2 * k) << 2 * k, 2 * k + 2, 2 * k + 1;
    strip.Triangles.row(2 * k + 1) << 2 * k + 1, 2 * k + 2, 2 * k + 3;
  }
  return strip;
}

/// The map between two meshes of the same triangles.
shape::SurfaceMaps SamePoints(const shape::Mesh& a, const shape::Mesh& b)
{
  const Eigen::VectorXi all =
    Eigen::VectorXi::LinSpaced(a.Points.rows(), 0, static_cast<int>(a.Points.rows()) - 1);
  return { shape::MakeSurfacePointsAtVertices(all, b), shape::MakeSurfacePointsAtVertices(all, a) };
}

/// |G - I| / sqrt(10) of the functions cos(i pi x), normalised, at x = along(u).
template <typename Along>
double ChangeOnLine(const Along& along)
{
  constexpr int functions = 10, steps = 100000;
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(functions, functions);
  for (int k = 0; k < steps; ++k)
  {
    Eigen::VectorXd values(functions);
    for (int i = 0; i < functions; ++i)
    {
      values(i) = (i == 0 ? 1.0 : std::sqrt(2.0)) * std::cos(i * Pi * along((k + 0.5) / steps));
    }
    gram += values * values.transpose() / steps;
  }
  return (gram - Eigen::MatrixXd::Identity(functions, functions)).norm() / std::sqrt(functions);
}

TEST(AreaChange, OfAStripIsThatOfALine)
{
  const auto straight = [](double u) { return u; };
  const auto bent = [](double u) { return 0.5 * (u + u * u); };
  const auto inverse = [](double x) { return -0.5 + std::sqrt(0.25 + 2.0 * x); };
  const shape::Mesh a = Strip(400, 0.01, straight), b = Strip(400, 0.01, bent);
  const double exact = 0.5 * (ChangeOnLine(bent) + ChangeOnLine(inverse));
  EXPECT_GT(exact, 0.1);
  EXPECT_NEAR(shape::ComputeAreaChange(a, b, SamePoints(a, b)), exact, 0.01 * exact);
}

TEST(AreaChange, IsZeroWhereAreasKeepTheirRatio)
{
  const shape::Mesh a = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  shape::Mesh b = a;
  b.Points *= 3.0;
  EXPECT_LT(shape::ComputeAreaChange(a, b, SamePoints(a, b)), 1e-6);
  // Lengths of a plane change, but all areas by the same factor. Each eigenproblem has triangles of
  // its own (intrinsic Delaunay), so masses differ a little.
  const shape::Mesh plane = Strip(100, 0.3, [](double u) { return u; });
  shape::Mesh stretched = plane;
  stretched.Points.col(1) *= 4.0;
  EXPECT_LT(shape::ComputeAreaChange(plane, stretched, SamePoints(plane, stretched)), 0.01);
}

TEST(ReversedArea, OfTheMapToAMirrorImageIsAll)
{
  const shape::Mesh a = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity()),
                    b = shapetest::Mirrored(a);
  EXPECT_DOUBLE_EQ(shape::ComputeReversedArea(a, a, SamePoints(a, a).AToB), 0.0);
  EXPECT_DOUBLE_EQ(shape::ComputeReversedArea(a, b, SamePoints(a, b).AToB), 1.0);
}

} // namespace
