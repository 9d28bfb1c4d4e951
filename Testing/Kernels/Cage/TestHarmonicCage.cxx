#include "Cage/CageDeform.h"
#include "Mesh/Mesh.h"
#include "Support/CageShapes.h"
#include "Support/ProgressChecks.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <vector>

namespace
{

using shape::CageCoordinates;
using shape::CageDeformOptions;
using shape::CageMovedPoints;
using shape::Mesh;
using namespace shapetest; // NOLINT(google-build-using-namespace)

} // namespace

TEST(HarmonicCage, ReproducesAffineMotions)
{
  for (const Mesh& cage : { Box({ -1, -2, -3 }, { 2, 2, 1 }), CornerCage(), PebbleCage(2, 1e6) })
  {
    const Eigen::MatrixXd points =
      Stacked(PointsAround(cage, 300, 1.0), PointsNear(cage, Sides::Inner));
    EXPECT_LT(
      AffineError(cage, Shear(), points, WithCoordinates(CageCoordinates::Harmonic)), 1e-10);
  }
}

TEST(HarmonicCage, ConvergesToHarmonicFields)
{
  // x^2 - y^2 on a finely triangulated sphere.
  const Mesh sphere = Icosphere(4);
  const auto field = [](const Eigen::MatrixXd& at)
  {
    Eigen::MatrixXd values = at;
    values.col(2) += (at.col(0).array().square() - at.col(1).array().square()).matrix();
    return values;
  };
  const Eigen::MatrixXd points = PointsAround(sphere, 2000, 1.1);
  std::vector<double> errors;
  for (const int count : { 25000, CageDeformOptions().Tetrahedra })
  {
    CageDeformOptions options = WithCoordinates(CageCoordinates::Harmonic);
    options.Tetrahedra = count;
    const CageMovedPoints moved = MoveByCage(sphere, field(sphere.Points), points, options);
    const std::vector<int> rows = RowsInside(moved);
    EXPECT_GT(rows.size(), 700U);
    const Eigen::MatrixXd difference = moved.Points - field(points);
    errors.push_back(0.5 * Eigen::MatrixXd(difference(rows, Eigen::all)).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(errors[1], 1e-3);
  EXPECT_GT(errors[0], 2.5 * errors[1]); // eight times as many: 4 for the second order
}

TEST(HarmonicCage, TheNumberOfTetrahedraIsAboutTheGivenOne)
{
  const Mesh cage = Icosphere(2);
  for (const int count : { 20000, 100000 })
  {
    CageDeformOptions options = WithCoordinates(CageCoordinates::Harmonic);
    options.Tetrahedra = count;
    const int made = shape::CageDeformer(cage, cage.Points, options).GetTetrahedra();
    EXPECT_GT(made, 0.7 * count);
    EXPECT_LT(made, 1.4 * count);
  }
}

TEST(HarmonicCage, FollowsTheCageOnItAndIsContinuousThere)
{
  ExpectFollowsCage(CageCoordinates::Harmonic);
}

TEST(HarmonicCage, AffineMotionsHaveTheirGradient)
{
  ExpectAffineGradients(CageCoordinates::Harmonic);
}

TEST(HarmonicCage, PointsOutsideStay)
{
  ExpectOutsideStays(CageCoordinates::Harmonic);
}

TEST(HarmonicCage, ProgressRisesAndStops)
{
  ExpectReports(CageCoordinates::Harmonic);
}
