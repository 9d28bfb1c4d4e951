#include "Support/Refusals.h"
#include "Support/TestShapes.h"
#include "Transfer/PaintArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using Mode = shape::BrushStroke::ModeType;

shape::BrushStroke Stroke(
  Mode mode, double radius, double strength, double value, const Eigen::MatrixXd& positions)
{
  shape::BrushStroke stroke;
  stroke.Mode = mode;
  stroke.Radius = radius;
  stroke.Strength = strength;
  stroke.Value = value;
  stroke.Positions = positions;
  return stroke;
}

/// Positions along a quarter of the equator.
Eigen::MatrixXd Equator(int count)
{
  Eigen::MatrixXd positions(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double angle = M_PI / 2.0 * i / count;
    positions.row(i) << std::cos(angle), std::sin(angle), 0.0;
  }
  return positions;
}

/// The weight of a point by its definition.
double Weight(const Eigen::RowVector3d& point, const Eigen::MatrixXd& positions, Eigen::Index row,
  double radius)
{
  const double share = (point - positions.row(row)).norm() / radius;
  return share < 1.0 ? std::pow(1.0 - share * share, 2) : 0.0;
}

/// Two parallel squares of (n + 1)^2 points, at the heights 0 and `gap`, that nothing joins.
shape::Mesh Sheets(int n, double gap)
{
  shape::Mesh mesh;
  mesh.Points.resize(2 * (n + 1) * (n + 1), 3);
  mesh.Triangles.resize(4 * n * n, 3);
  int triangle = 0;
  for (int sheet = 0; sheet < 2; ++sheet)
  {
    const int first = sheet * (n + 1) * (n + 1);
    for (int i = 0; i <= n; ++i)
    {
      for (int j = 0; j <= n; ++j)
      {
        const int corner = first + i * (n + 1) + j;
        mesh.Points.row(corner) << 2.0 * i / n - 1.0, 2.0 * j / n - 1.0, sheet * gap;
        if (i < n && j < n)
        {
          mesh.Triangles.row(triangle++) << corner, corner + n + 1, corner + n + 2;
          mesh.Triangles.row(triangle++) << corner, corner + n + 2, corner + 1;
        }
      }
    }
  }
  return mesh;
}

} // namespace

TEST(PaintArray, SetAndAddActByTheDistanceToTheNearestPosition)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const Eigen::MatrixXd positions = Equator(25);
  const Eigen::VectorXd initial = sphere.Points.col(2);
  for (const Mode mode : { Mode::Set, Mode::Add })
  {
    const Eigen::VectorXd values =
      shape::PaintArray(sphere, initial, { Stroke(mode, 0.3, 0.7, 5.0, positions) });
    int painted = 0;
    for (Eigen::Index i = 0; i < values.size(); ++i)
    {
      double weight = 0.0;
      for (Eigen::Index p = 0; p < positions.rows(); ++p)
      {
        weight = std::max(weight, Weight(sphere.Points.row(i), positions, p, 0.3));
      }
      const double change = mode == Mode::Set ? 5.0 - initial(i) : 5.0;
      EXPECT_NEAR(values(i), initial(i) + 0.7 * weight * change, 1e-14);
      painted += weight > 0.0;
    }
    EXPECT_GT(painted, 200);
    EXPECT_LT(painted, values.size() / 2);
  }
}

// However slowly the brush moves, a stroke acts once: more positions between the same change
// little.
TEST(PaintArray, SpeedOfTheBrushDoesNotMatter)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(sphere.Points.rows());
  const double radius = 0.3;
  const int fast = static_cast<int>(M_PI / 2.0 / (radius / 8.0)) + 1;
  const Eigen::VectorXd one =
    shape::PaintArray(sphere, zero, { Stroke(Mode::Add, radius, 1.0, 1.0, Equator(fast)) });
  const Eigen::VectorXd other =
    shape::PaintArray(sphere, zero, { Stroke(Mode::Add, radius, 1.0, 1.0, Equator(8 * fast)) });
  // A point at the distance d from the path is at most (1 / 16) radius farther along it.
  const Eigen::MatrixXd end = Equator(8 * fast).bottomRows(1);
  for (Eigen::Index i = 0; i < one.size(); ++i)
  {
    if (Weight(sphere.Points.row(i), end, 0, radius) == 0.0)
    {
      EXPECT_NEAR(one(i), other(i), 2.0 / 256.0);
    }
  }
}

TEST(PaintArray, SmoothKeepsTheIntegralAndReachesTheMean)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::VectorXd areas = shape::ComputePointAreas(sphere);
  const Eigen::VectorXd initial = (5.0 * sphere.Points.col(0)).array().sin();

  // The whole sphere is in the ball, whose radius makes nearly equal weights.
  const Eigen::MatrixXd top = Eigen::RowVector3d(0.0, 0.0, 1.0);
  const shape::BrushStroke all = Stroke(Mode::Smooth, 2.5, 1.0, 0.0, top.replicate(400, 1));
  const Eigen::VectorXd flat = shape::PaintArray(sphere, initial, { all });
  const double mean = areas.dot(initial) / areas.sum();
  EXPECT_LT((flat.array() - mean).abs().maxCoeff(), 1e-12);

  // A part of it: the integral stays, points outside the ball do, and the variation decreases.
  const Eigen::VectorXd part =
    shape::PaintArray(sphere, initial, { Stroke(Mode::Smooth, 0.8, 0.5, 0.0, Equator(20)) });
  EXPECT_NEAR(areas.dot(part), areas.dot(initial), 1e-13);
  EXPECT_LT((areas.array() * part.array().square()).sum(),
    (areas.array() * initial.array().square()).sum() - 0.1);
  for (Eigen::Index i = 0; i < part.size(); ++i)
  {
    if (sphere.Points(i, 2) < -0.8)
    {
      EXPECT_EQ(part(i), initial(i));
    }
  }
}

TEST(PaintArray, OtherSideOfAThinPartStays)
{
  const int n = 40;
  const Eigen::Index sheet = (n + 1) * (n + 1);
  const shape::Mesh sheets = Sheets(n, 0.01);
  const Eigen::MatrixXd centre = Eigen::RowVector3d(0.0, 0.0, -0.001);
  const Eigen::VectorXd values = shape::PaintArray(
    sheets, Eigen::VectorXd::Zero(2 * sheet), { Stroke(Mode::Set, 0.5, 1.0, 1.0, centre) });
  EXPECT_GT(values.head(sheet).maxCoeff(), 0.9);
  EXPECT_EQ(values.tail(sheet).maxCoeff(), 0.0);
}

// A soup of triangles is painted as the surface that it represents.
TEST(PaintArray, SeamsAreCrossed)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  shape::Mesh soup;
  soup.Points.resize(3 * sphere.Triangles.rows(), 3);
  soup.Triangles.resize(sphere.Triangles.rows(), 3);
  Eigen::VectorXi of(soup.Points.rows());
  for (Eigen::Index t = 0; t < sphere.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      of(3 * t + k) = sphere.Triangles(t, k);
      soup.Points.row(3 * t + k) = sphere.Points.row(sphere.Triangles(t, k));
      soup.Triangles(t, k) = static_cast<int>(3 * t + k);
    }
  }
  const std::vector<shape::BrushStroke> strokes{ Stroke(Mode::Add, 0.5, 1.0, 2.0, Equator(9)),
    Stroke(Mode::Smooth, 0.7, 0.6, 0.0, Equator(5)) };
  const Eigen::VectorXd one =
    shape::PaintArray(sphere, Eigen::VectorXd::Ones(sphere.Points.rows()), strokes);
  const Eigen::VectorXd other =
    shape::PaintArray(soup, Eigen::VectorXd::Ones(soup.Points.rows()), strokes);
  EXPECT_LT((other - one(of)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(PaintArray, AppendedStrokesGiveTheSameBits)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::VectorXd initial = sphere.Points.col(0);
  const Eigen::MatrixXd path = Equator(30);
  const shape::BrushStroke first = Stroke(Mode::Set, 0.4, 0.5, 3.0, path.topRows(10));
  const shape::BrushStroke second = Stroke(Mode::Smooth, 0.5, 0.5, 0.0, path);
  shape::SurfacePainter painter(sphere, initial);
  const auto check = [&](const std::vector<shape::BrushStroke>& strokes)
  { EXPECT_EQ(painter.Paint(strokes), shape::PaintArray(sphere, initial, strokes)); };
  check({});
  check({ first });
  for (const int rows : { 1, 2, 7, 30 })
  {
    check({ first, Stroke(Mode::Smooth, 0.5, 0.5, 0.0, path.topRows(rows)) });
  }
  check({ first, second, first });
  check({ first, second }); // the last stroke is undone
  check({ second, first });
  check({ Stroke(Mode::Set, 0.4, 0.25, 3.0, path.topRows(10)), first });
  check({});
}

TEST(PaintArray, InvalidStrokesAreRefused)
{
  const shape::Mesh sphere = shapetest::Icosphere(1);
  const Eigen::VectorXd initial = Eigen::VectorXd::Zero(sphere.Points.rows());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Eigen::MatrixXd path = Equator(2);
  const shape::BrushStroke good = Stroke(Mode::Set, 1.0, 1.0, 1.0, path);
  const auto paint = [&](const shape::BrushStroke& stroke) {
    shape::PaintArray(sphere, initial, { good, stroke });
  };
  EXPECT_REFUSED(paint(Stroke(Mode::Set, 0.0, 1.0, 1.0, path)), "Radius of stroke 1 is 0");
  EXPECT_REFUSED(paint(Stroke(Mode::Set, 1.0, 1.5, 1.0, path)), "Strength of stroke 1 is 1.5");
  EXPECT_REFUSED(paint(Stroke(Mode::Set, 1.0, 1.0, nan, path)), "Value of stroke 1 is nan");
  EXPECT_REFUSED(
    paint(Stroke(Mode::Set, 1.0, 1.0, 1.0, nan * path)), "position of stroke 1", "not finite");
  EXPECT_REFUSED(shape::PaintArray(sphere, initial.head(3), { good }), "3 initial values");
  EXPECT_REFUSED(
    shape::PaintArray(sphere, nan * Eigen::VectorXd::Ones(initial.size()), {}), "not finite");
  EXPECT_REFUSED(
    shape::PaintArray(shape::Mesh{ sphere.Points, Eigen::MatrixXi(0, 3) }, initial, {}),
    "triangle");
}
