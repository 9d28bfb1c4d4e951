#include "Base/Errors.h"
#include "Correspondence/Evaluate/FromOperators.h"
#include "Correspondence/Evaluate/MapDifference.h"
#include "Mesh/Surface.h"
#include "Support/MatchingShapes.h"
#include "Support/TestShapes.h"

#include <Eigen/SVD>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

using shapetest::DistanceFrom;
using shapetest::IdentityMap;

shape::MapDifferenceResult Differences(const shape::Surface& first, const shape::Surface& second)
{
  shape::MapDifferenceOptions options;
  options.NumberOfEigenpairs = 60;
  options.Products = shape::MapDifferenceOptions::ProductsType::Triangles;
  return shape::MapDifference(first, second, IdentityMap(second), options);
}

/// A plate bent to a part of a cylinder of radius 1.5, which keeps lengths up to the chords.
shape::Mesh Rolled(shape::Mesh plate)
{
  for (Eigen::Index i = 0; i < plate.Points.rows(); ++i)
  {
    const double angle = plate.Points(i, 0) / 1.5;
    plate.Points(i, 0) = 1.5 * std::sin(angle);
    plate.Points(i, 2) = 1.5 * std::cos(angle);
  }
  return plate;
}

} // namespace

TEST(FromOperators, OffsetSurfacesSayHowASurfaceBends)
{
  // Both plates have the same lengths. Only the offset surface knows that one is bent.
  const shape::Mesh plate = shapetest::FlatSquare(24, 0.2);
  const shape::Mesh rolled = Rolled(plate);
  const shape::MapDifferenceResult lengths = Differences(plate, rolled);
  shape::SurfaceOperators operators{ lengths.Area.Matrix, lengths.Conformal.Matrix };
  const shape::RecoveredSurface bendable = shape::RecoverFromOperators(plate, operators);
  EXPECT_GT(DistanceFrom(bendable.Embedded.Points, rolled), 0.03);
  EXPECT_LT(bendable.Embedded.LengthError, 1e-3);
  EXPECT_EQ(bendable.Curvatures.size(), 0);

  operators.OffsetDistance = 0.1;
  const shape::MapDifferenceResult offset =
    Differences(shape::OffsetSurface(plate, 0.1, "it"), shape::OffsetSurface(rolled, 0.1, "it"));
  operators.OffsetArea = offset.Area.Matrix;
  operators.OffsetConformal = offset.Conformal.Matrix;
  const shape::RecoveredSurface bent = shape::RecoverFromOperators(plate, operators);
  EXPECT_LT(DistanceFrom(bent.Embedded.Points, rolled), 0.003);
  // Euler: from 1 / 1.5 around the cylinder to 0 along it.
  EXPECT_NEAR(bent.Curvatures.mean(), 0.5 / 1.5, 0.1);
}
