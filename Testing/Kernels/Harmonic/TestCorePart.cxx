#include "Harmonic/Private/CorePart.h"

#include "Geometry/PositiveTetrahedron.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{

using shape::CorePart;
using shape::FiniteElements;
using shape::UntanglePart;

/// Pulls a cap of the unit ball out into a horn around the x axis, of a half turn.
Eigen::MatrixXd PullHorn(const Eigen::MatrixXd& points)
{
  constexpr double base = 0.2, height = 8.0, radius = 2.0;
  Eigen::MatrixXd pulled = points;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (points(i, 2) > base)
    {
      const double angle = height * (points(i, 2) - base) / radius;
      const double distance = radius - points(i, 0);
      pulled(i, 0) = radius - distance * std::cos(angle);
      pulled(i, 2) = base + distance * std::sin(angle);
    }
  }
  return pulled;
}

/// A ball whose boundary goes to PullHorn, and inner points stay where they are. The horn is longer
/// than the tetrahedra suit: few points are inside of it.
CorePart MakeHorn()
{
  const shape::Surface ball(shapetest::Icosphere(4));
  CorePart part;
  part.Elements = shape::FillWithElements(ball, PullHorn(ball.Points()), 100, true, 0);
  std::vector<char> atBoundary(part.Elements.Points.rows(), 0);
  for (const int point : part.Elements.Boundary.reshaped())
  {
    atBoundary[point] = 1;
  }
  for (std::size_t i = 0; i < atBoundary.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    if (atBoundary[i] == 0)
    {
      part.Elements.Images.row(row) = part.Elements.Points.row(row);
    }
  }
  part.Points.resize(part.Elements.Points.rows());
  std::iota(part.Points.begin(), part.Points.end(), 0);
  return part;
}

double Volume(const FiniteElements& elements)
{
  double volume = 0.0;
  for (const Eigen::RowVector4i ids : elements.Tetrahedra.rowwise())
  {
    const Eigen::Matrix<double, 4, 3> corners = elements.Points(ids, Eigen::all);
    volume += (corners.bottomRows<3>().rowwise() - corners.row(0)).determinant() / 6.0;
  }
  return volume;
}

int CountInverted(const FiniteElements& elements)
{
  int inverted = 0;
  for (const Eigen::RowVector4i ids : elements.Tetrahedra.rowwise())
  {
    inverted +=
      !shape::IsPositive(elements.Points, ids) || !shape::IsPositive(elements.Images, ids);
  }
  return inverted;
}

// Little work does not untangle the ball in the horn, but the horn in the ball, which is convex.
TEST(CorePart, IsMappedInverselyIfThatInvertsLess)
{
  CorePart part = MakeHorn();
  const FiniteElements given = part.Elements;
  ASSERT_GT(CountInverted(given), 500);
  UntanglePart(part, 1e5, {});
  EXPECT_TRUE(part.IsUntangled);
  EXPECT_EQ(CountInverted(part.Elements), 0);
  EXPECT_NEAR(Volume(part.Elements), Volume(given), 1e-12);
  ASSERT_LT(part.Points.size(), static_cast<std::size_t>(given.Points.rows()))
    << "the tetrahedra are new";
  const auto count = static_cast<Eigen::Index>(part.Points.size());
  EXPECT_EQ(part.Elements.Points.topRows(count), given.Points(part.Points, Eigen::all));
  EXPECT_EQ(part.Elements.Images.topRows(count), given.Images(part.Points, Eigen::all));
}

/// The boundary of two tetrahedra that share the given number of points.
shape::Surface TwoTetrahedra(int shared)
{
  FiniteElements elements;
  elements.Points = Eigen::MatrixXd::Random(8 - shared, 3);
  elements.Tetrahedra.resize(2, 4);
  elements.Tetrahedra << 0, 1, 2, 3, 4 - shared, 5 - shared, 6 - shared, 7 - shared;
  return { elements.Points, shape::FindBoundaryTriangles(elements) };
}

TEST(CorePart, FindsWhereABoundaryTouchesItself)
{
  const auto find = [](int shared)
  {
    std::vector<int> points = shape::FindPinches(TwoTetrahedra(shared));
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
  };
  EXPECT_EQ(find(0), std::vector<int>());
  EXPECT_EQ(find(1), std::vector<int>({ 3 }));
  EXPECT_EQ(find(2), std::vector<int>({ 2, 3 }));
  EXPECT_EQ(find(3), std::vector<int>());
}

} // namespace
