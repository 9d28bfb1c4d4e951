#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Hex/Polycube/Polycube.h"
#include "Hex/Polycube/PolycubeHexes.h"
#include "Hex/Polycube/Private/AxisAlignment.h"
#include "Hex/Polycube/Private/IntegerMapHexes.h"
#include "Hex/Polycube/Private/PolycubeMap.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Quality/ScaledJacobian.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace
{

void ExpectPolycube(const shape::Mesh& surface, const shape::PolycubeResult& polycube)
{
  ASSERT_EQ(polycube.Positions.rows(), surface.Points.rows());
  ASSERT_EQ(polycube.Labels.size(), surface.Triangles.rows());
  const shape::Mesh image{ polycube.Positions, surface.Triangles };
  const Eigen::MatrixXd vectors = shape::ComputeAreaVectors(image);
  for (Eigen::Index f = 0; f < vectors.rows(); ++f)
  {
    const int axis = polycube.Labels(f) / 2;
    EXPECT_GT(vectors.row(f).dot(shape::GetLabelAxis(polycube.Labels(f))), 0.0) << f;
    const Eigen::Matrix3d corners = shape::GetCorners(image, f);
    EXPECT_EQ(corners(0, axis), corners(1, axis)) << f;
    EXPECT_EQ(corners(0, axis), corners(2, axis)) << f;
    const double position = corners(0, axis) / polycube.EdgeLength;
    EXPECT_NEAR(position, std::round(position), 1e-12) << f;
    EXPECT_EQ(shape::FindPolygonLabel(corners), polycube.Labels(f));
  }
}

void ExpectPositive(const shape::PolycubeMap& map)
{
  for (const auto& c : map.Solid.Tetrahedra.rowwise())
  {
    for (const Eigen::MatrixXd* points : { &map.Solid.Points, &map.Positions })
    {
      EXPECT_EQ(shape::EvaluateOrientation(
                  points->row(c(0)), points->row(c(1)), points->row(c(2)), points->row(c(3))),
        1);
    }
  }
}

} // namespace

TEST(Polycube, ABallBecomesACube)
{
  const shape::Mesh ball = shapetest::Icosphere(3);
  const shape::PolycubeResult polycube = shape::BuildPolycube(ball);
  EXPECT_EQ(polycube.Charts, 6);
  EXPECT_EQ(polycube.Corners, 8);
  ExpectPolycube(ball, polycube);
  const shape::Mesh inwards{ ball.Points, ball.Triangles.rowwise().reverse() };
  const shape::PolycubeResult turned = shape::BuildPolycube(inwards);
  EXPECT_EQ(turned.Charts, 6);
  EXPECT_LT(shape::ComputeEnclosedVolume({ turned.Positions, inwards.Triangles }), 0.0);
  const double volume = shape::ComputeEnclosedVolume({ polycube.Positions, ball.Triangles });
  EXPECT_NEAR(volume / shape::ComputeEnclosedVolume(ball), 1.0, 0.2);
}

TEST(Polycube, ATorusBecomesARing)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.4, 60, 30);
  const shape::PolycubeMap map =
    shape::FindPolycubeMap(torus, shape::PolycubeOptions().Compactness);
  ExpectPositive(map);
  EXPECT_EQ(map.Charts.Count(), 10);
  // The cells are as many as the polycube's volume.
  const shape::IntegerMapHexesResult hexes =
    shape::ExtractIntegerMapHexahedra(map.Solid.Points, map.Positions, map.Solid.Tetrahedra);
  EXPECT_EQ(static_cast<double>(hexes.Solid.Hexahedra.rows()),
    std::round(shape::ComputeEnclosedVolume(map.Solid.Surface(map.Positions))));
  EXPECT_FALSE(hexes.Overlaps);
  const shape::Mesh boundary{ hexes.Positions,
    shape::SplitQuads(shape::FindBoundaryQuads(hexes.Solid)) };
  EXPECT_EQ(shape::RequireClosedSurface(boundary, "the boundary").EulerNumber, 0);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(boundary), hexes.Solid.Hexahedra.rows(), 1e-6);
}

TEST(Polycube, HexahedraOfABall)
{
  const shape::Mesh ball = shapetest::Icosphere(3);
  shape::PolycubeHexesOptions options;
  options.CellSize = 0.2;
  const shape::PolycubeHexesResult result = shape::BuildPolycubeHexahedra(ball, options);
  EXPECT_EQ(result.Charts, 6);
  EXPECT_EQ(result.Corners, 8);
  EXPECT_EQ(result.Fit.Inverted, 0);
  EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.6);
  EXPECT_GT(result.Fit.MeanScaledJacobian, 0.93);
  const Eigen::VectorXd quality = shape::ComputeScaledJacobians(result.Fit.Solid);
  EXPECT_EQ(quality.minCoeff(), result.Fit.MinimumScaledJacobian);
  const shape::Mesh boundary{ result.Fit.Solid.Points,
    shape::SplitQuads(shape::FindBoundaryQuads(result.Fit.Solid)) };
  EXPECT_EQ(shape::RequireClosedSurface(boundary, "the boundary").EulerNumber, 2);
  EXPECT_NEAR(
    shape::ComputeEnclosedVolume(boundary) / shape::ComputeEnclosedVolume(ball), 1.0, 0.02);
  ASSERT_EQ(result.Targets.rows(), result.Polycube.Points.rows());
  EXPECT_GT(shape::ComputeEnclosedVolume(result.Polycube), 0.0);
}

TEST(Polycube, OptionsAndSurfacesAreChecked)
{
  const shape::Mesh ball = shapetest::Icosphere(1);
  shape::PolycubeOptions options;
  options.Compactness = 0.0;
  EXPECT_THROW(shape::BuildPolycube(ball, options), shape::InvalidInput);
  options = {};
  options.TargetEdgeLength = -1.0;
  EXPECT_THROW(shape::BuildPolycube(ball, options), shape::InvalidInput);
  EXPECT_THROW(shape::BuildPolycube(shapetest::FlatDisk(3)), shape::InvalidInput);
  EXPECT_THROW(shape::BuildPolycube(ball, {}, { [](double) { return false; } }), shape::Aborted);
}
