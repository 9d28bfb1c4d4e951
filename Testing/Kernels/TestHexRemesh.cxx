#include "Core/Errors.h"
#include "Core/Topology.h"
#include "Hex/HexRemesh.h"
#include "Quality/ScaledJacobian.h"
#include "TestShapes.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

using MethodType = shape::HexRemeshOptions::MethodType;

shape::Topology BoundaryTopology(const shape::HexFit& fit)
{
  return shape::RequireClosedSurface(
    { fit.Solid.Points, shape::SplitQuads(fit.Quads) }, "the boundary");
}

} // namespace

TEST(HexRemesh, EveryMethodFillsATorus)
{
  const shape::Mesh torus = shapetest::Torus(1.0, 0.45, 60, 30);
  shape::HexRemeshOptions options;
  options.CellSize = 0.14;
  for (const MethodType method : { MethodType::Grid, MethodType::Polycube, MethodType::Automatic })
  {
    options.Method = method;
    const shape::HexRemeshResult result = shape::HexRemesh(torus, options);
    EXPECT_TRUE(method == MethodType::Automatic || result.Method == method);
    EXPECT_FALSE(result.Reason.empty());
    EXPECT_EQ(BoundaryTopology(result.Fit).EulerNumber, 0);
    EXPECT_EQ(result.Fit.LeastScaledJacobian, shape::ScaledJacobians(result.Fit.Solid).minCoeff());
    EXPECT_GT(result.Fit.LeastScaledJacobian, 0.3);
    EXPECT_NEAR(
      shape::EnclosedVolume({ result.Fit.Solid.Points, shape::SplitQuads(result.Fit.Quads) }),
      shape::EnclosedVolume(torus), 0.03 * shape::EnclosedVolume(torus));
  }
}

TEST(HexRemesh, ASurfaceThatCrossesItselfIsFilledByAGrid)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::Index n = sphere.Points.rows(), m = sphere.Triangles.rows();
  shape::Mesh surface{ Eigen::MatrixXd(2 * n, 3), Eigen::MatrixXi(2 * m, 3) };
  surface.Points << sphere.Points, sphere.Points.rowwise() + Eigen::RowVector3d(1.01, 0.02, 0.03);
  surface.Triangles << sphere.Triangles, sphere.Triangles.array() + static_cast<int>(n);
  shape::HexRemeshOptions options;
  options.CellSize = 0.2;
  const shape::HexRemeshResult result = shape::HexRemesh(surface, options);
  EXPECT_EQ(result.Method, MethodType::Grid);
  EXPECT_GT(result.Crossings, 0);
  EXPECT_NE(result.Reason.find("crosses itself"), std::string::npos) << result.Reason;
  EXPECT_EQ(BoundaryTopology(result.Fit).Components, 1);
  options.Method = MethodType::Polycube;
  EXPECT_THROW(shape::HexRemesh(surface, options), shape::InvalidInput);
}

TEST(HexRemesh, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  shape::HexRemeshOptions options;
  options.CellSize = std::numeric_limits<double>::infinity();
  EXPECT_THROW(shape::HexRemesh(sphere, options), shape::InvalidInput);
  options.CellSize = 0.2;
  options.PaddingLayers = 0;
  EXPECT_THROW(shape::HexRemesh(sphere, options), shape::InvalidInput);
  options.PaddingLayers = 1;
  options.FeatureAngle = 181.0;
  EXPECT_THROW(shape::HexRemesh(sphere, options), shape::InvalidInput);
  options.FeatureAngle = 40.0;
  shape::Mesh open = sphere;
  open.Triangles.conservativeResize(open.Triangles.rows() - 1, 3);
  EXPECT_THROW(shape::HexRemesh(open, options), shape::InvalidInput);
}
