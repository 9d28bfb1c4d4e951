#include "Base/Errors.h"
#include "Spectrum/Private/ClassicalMds.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// A plate of sides 2 and 1, and the same bent to half a cylinder.
struct Plates
{
  shape::Mesh Flat, Bent;
};

Plates MakePlates(int cells)
{
  Plates plates{ shapetest::FlatSquare(cells, 0.0), {} };
  plates.Flat.Points.col(1) *= 0.5;
  plates.Bent = plates.Flat;
  constexpr double radius = 2.0 / M_PI;
  const Eigen::ArrayXd angles = plates.Flat.Points.col(0).array() / radius;
  plates.Bent.Points.col(0) = radius * angles.sin();
  plates.Bent.Points.col(2) = radius * angles.cos();
  return plates;
}

} // namespace

TEST(ClassicalScaling, UnbendsAPlate)
{
  const Plates plates = MakePlates(34);
  const Eigen::MatrixXd found = shape::EmbedByClassicalMds(plates.Bent, 3, 100);
  double worst = 0.0;
  for (Eigen::Index i = 0; i < found.rows(); i += 7)
  {
    for (Eigen::Index j = 0; j < i; j += 11)
    {
      const double wanted = (plates.Flat.Points.row(i) - plates.Flat.Points.row(j)).norm();
      worst = std::max(worst, std::abs((found.row(i) - found.row(j)).norm() - wanted));
    }
  }
  EXPECT_LT(worst, 0.1); // its diagonal is 2.24, and heat's distances are not exact
  const Eigen::RowVectorXd spread = found.colwise().norm();
  EXPECT_LT(spread(2), 0.35 * spread(1)); // 0.69 in space
  EXPECT_LT(spread(1), spread(0));
}

TEST(ClassicalScaling, RefusesWhatIsNotOneComponent)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const shape::Mesh both = shapetest::Twice(sphere);
  EXPECT_THROW(shape::EmbedByClassicalMds(both, 3, 50), shape::InvalidInput);
}

TEST(ClassicalScaling, PointsWithoutATriangleAreAtTheOrigin)
{
  shape::Mesh mesh = shapetest::Icosphere(2);
  mesh.Points.conservativeResize(mesh.Points.rows() + 1, 3);
  mesh.Points.bottomRows(1).setConstant(9.0);
  const Eigen::MatrixXd found = shape::EmbedByClassicalMds(mesh, 3, 50);
  EXPECT_TRUE(found.allFinite());
  EXPECT_EQ(found.bottomRows(1), Eigen::RowVector3d::Zero());
  EXPECT_GT(found.topRows(mesh.Points.rows() - 1).rowwise().norm().minCoeff(), 0.5);
}
