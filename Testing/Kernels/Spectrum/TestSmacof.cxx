#include "Base/Errors.h"
#include "Geodesics/HeatGeodesics.h"
#include "Spectrum/Private/ClassicalMds.h"
#include "Spectrum/Smacof.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

/// The largest error of straight distances between places, over the largest distance.
double WorstDistance(const Eigen::MatrixXd& found, const Eigen::MatrixXd& wanted)
{
  double worst = 0.0, largest = 0.0;
  for (Eigen::Index i = 0; i < found.rows(); i += 7)
  {
    for (Eigen::Index j = 0; j < i; j += 5)
    {
      const double distance = (wanted.row(i) - wanted.row(j)).norm();
      worst = std::max(worst, std::abs((found.row(i) - found.row(j)).norm() - distance));
      largest = std::max(largest, distance);
    }
  }
  return worst / largest;
}

TEST(StressScaling, ARolledSheetIsFlatAgain)
{
  const shape::Mesh sheet = shapetest::FlatSquare(24, 0.0);
  shape::Mesh rolled = sheet;
  for (Eigen::Index i = 0; i < rolled.Points.rows(); ++i)
  {
    const double x = sheet.Points(i, 0);
    rolled.Points.row(i) << std::cos(x), sheet.Points(i, 1), std::sin(x);
  }
  const Eigen::MatrixXd found = shape::EmbedBySmacof(rolled);
  EXPECT_EQ(found.cols(), 8);
  EXPECT_LT(WorstDistance(found, sheet.Points), 0.03); // distances by heat are as good as that
}

TEST(StressScaling, HasLessStressThanClassicalScaling)
{
  const shape::Mesh torus = shapetest::Torus(2.0, 0.8, 60, 30);
  std::vector<int> points;
  for (int i = 0; i < torus.Points.rows(); i += 23)
  {
    points.push_back(i);
  }
  const Eigen::MatrixXd distances = shape::ComputeHeatDistances(torus, points)(points, Eigen::all);
  const auto stress = [&](const Eigen::MatrixXd& positions)
  {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < distances.rows(); ++i)
    {
      for (Eigen::Index j = 0; j < i; ++j)
      {
        const double wanted = 0.5 * (distances(i, j) + distances(j, i));
        sum += std::pow((positions.row(points[i]) - positions.row(points[j])).norm() - wanted, 2);
      }
    }
    return sum;
  };
  EXPECT_LT(
    stress(shape::EmbedBySmacof(torus)), 0.5 * stress(shape::EmbedByClassicalMds(torus, 8)));
}

TEST(StressScaling, RefusesSeveralComponents)
{
  EXPECT_THROW(
    shape::EmbedBySmacof(shapetest::Twice(shapetest::Icosphere(1))), shape::InvalidInput);
}

} // namespace
