#include "Correspondence/Landmarks/Landmarks.h"

#include "Base/Errors.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

std::string MessageFor(const Eigen::MatrixXd& positions, double maximum = 0.1)
{
  shape::LandmarksOptions options;
  options.MaximumDistance = maximum;
  try
  {
    shape::ProjectLandmarks(shapetest::Icosphere(3), positions, "Surface A", options);
  }
  catch (const shape::InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(Landmarks, AreMovedToTheSurface)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  Eigen::MatrixXd positions(2, 3);
  positions << 1.1 * sphere.Points.row(5), 0.95 * sphere.Points.row(40);
  const shape::LandmarksResult result = shape::ProjectLandmarks(sphere, positions, "Surface A");
  EXPECT_NEAR((result.Positions.row(0) - sphere.Points.row(5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(result.LargestDistance, 0.1, 1e-12);
  // 0.95 times a vertex is inside, and closest to a triangle around this vertex.
  EXPECT_LT((result.Positions.row(1) - sphere.Points.row(40)).norm(), 0.05);
}

TEST(Landmarks, MayBeNone)
{
  const shape::LandmarksResult result =
    shape::ProjectLandmarks(shapetest::Icosphere(1), Eigen::MatrixXd(0, 3), "Surface A");
  EXPECT_EQ(result.Positions.rows(), 0);
  EXPECT_EQ(result.LargestDistance, 0.0);
}

TEST(Landmarks, MustBeNearTheSurface)
{
  Eigen::MatrixXd positions(2, 3);
  positions << 1.0, 0.0, 0.0, 0.0, 0.0, 3.0;
  const std::string message = MessageFor(positions);
  EXPECT_NE(message.find("landmark 2 is 2"), std::string::npos) << message;
  EXPECT_NE(message.find("away from Surface A"), std::string::npos) << message;
  EXPECT_EQ(MessageFor(positions, 1.0), "");
}

TEST(Landmarks, MustDiffer)
{
  Eigen::MatrixXd positions(3, 3);
  positions << 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0;
  EXPECT_EQ(MessageFor(positions),
    "landmarks 1 and 3 have the same position on Surface A; remove one of them");
}

TEST(Landmarks, MustBeFinite)
{
  Eigen::MatrixXd positions(1, 3);
  positions << 1.0, std::numeric_limits<double>::quiet_NaN(), 0.0;
  EXPECT_NE(MessageFor(positions).find("the landmarks on Surface A"), std::string::npos);
}
