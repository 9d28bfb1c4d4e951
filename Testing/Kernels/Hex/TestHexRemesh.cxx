#include "Hex/HexRemesh.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfaceWork.h"
#include "Mesh/Topology.h"
#include "Quality/ScaledJacobian.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>

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
  std::map<MethodType, Eigen::MatrixXd> points;
  for (const MethodType method : { MethodType::Grid, MethodType::Polycube, MethodType::Automatic })
  {
    options.Method = method;
    const shape::SurfaceWork work(torus.Points);
    const shape::HexRemeshResult result = shape::RemeshHexahedra(torus, options);
    // The surface goes through all kernels as it is: none checks or indexes a copy.
    EXPECT_EQ(work.Count(shape::SurfaceWork::Kind::Topology), 1);
    EXPECT_EQ(work.Count(shape::SurfaceWork::Kind::SearchTree), 1);
    // Automatic gives the same bits as the method that it has chosen.
    const auto first = points.emplace(result.Method, result.Fit.Solid.Points).first;
    EXPECT_EQ(result.Fit.Solid.Points, first->second);
    EXPECT_TRUE(method == MethodType::Automatic || result.Method == method);
    EXPECT_FALSE(result.Reason.empty());
    EXPECT_EQ(BoundaryTopology(result.Fit).EulerNumber, 0);
    EXPECT_EQ(
      result.Fit.MinimumScaledJacobian, shape::ComputeScaledJacobians(result.Fit.Solid).minCoeff());
    EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.3);
    EXPECT_NEAR(shape::ComputeEnclosedVolume(
                  { result.Fit.Solid.Points, shape::SplitQuads(result.Fit.Quads) }),
      shape::ComputeEnclosedVolume(torus), 0.03 * shape::ComputeEnclosedVolume(torus));
  }
}

TEST(HexRemesh, ASurfaceThatCrossesItselfIsFilledByAGrid)
{
  const shape::Mesh surface = shapetest::Twice(shapetest::Icosphere(3), { 1.01, 0.02, 0.03 });
  shape::HexRemeshOptions options;
  options.CellSize = 0.28;
  const shape::HexRemeshResult result = shape::RemeshHexahedra(surface, options);
  EXPECT_EQ(result.Method, MethodType::Grid);
  EXPECT_GT(result.Crossings, 0);
  EXPECT_NE(result.Reason.find("intersects itself"), std::string::npos) << result.Reason;
  EXPECT_EQ(BoundaryTopology(result.Fit).Components, 1);
  options.Method = MethodType::Polycube;
  EXPECT_THROW(shape::RemeshHexahedra(surface, options), shape::InvalidInput);
}

TEST(HexRemesh, CellsOnTheLongestSideAreACellSize)
{
  shape::Mesh surface = shapetest::Icosphere(3);
  surface.Points.col(1) *= 1.5; // from -1.5 to 1.5
  shape::HexRemeshOptions options;
  options.Method = MethodType::Grid;
  options.CellSize = 0.25;
  const shape::HexRemeshResult sized = shape::RemeshHexahedra(surface, options);
  options.CellsOnLongestSide = 12;
  EXPECT_REFUSED(shape::RemeshHexahedra(surface, options), "CellSize", "CellsOnLongestSide");
  options.CellSize = 0.0;
  const shape::HexRemeshResult counted = shape::RemeshHexahedra(surface, options);
  EXPECT_EQ(counted.CellSize, sized.CellSize);
  EXPECT_EQ(counted.Fit.Solid.Points, sized.Fit.Solid.Points);
}

TEST(HexRemesh, GuidesNeedAGrid)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  shape::HexRemeshGuides sized, inner;
  sized.Sizes = Eigen::VectorXd::Constant(sphere.Points.rows(), 0.25);
  inner.InnerSurfaces = { { 0.5 * sphere.Points, sphere.Triangles } };
  shape::HexRemeshOptions options;
  shape::HexRemeshResult result = shape::RemeshHexahedra(sphere, options, {}, sized);
  EXPECT_EQ(result.Method, MethodType::Grid);
  EXPECT_NE(result.Reason.find("SizeArray"), std::string::npos) << result.Reason;
  EXPECT_EQ(result.SizeRatios.size(), result.Fit.Quads.rows());
  options.CellSize = 0.25;
  EXPECT_THROW(shape::RemeshHexahedra(sphere, options, {}, sized), shape::InvalidInput);
  result = shape::RemeshHexahedra(sphere, options, {}, inner);
  EXPECT_EQ(result.Method, MethodType::Grid);
  EXPECT_NE(result.Reason.find("InnerSurfaces"), std::string::npos) << result.Reason;
  EXPECT_EQ(result.Fit.RegionOf.maxCoeff(), 1);
  options.Method = MethodType::Polycube;
  EXPECT_THROW(shape::RemeshHexahedra(sphere, options, {}, inner), shape::InvalidInput);
}

TEST(HexRemesh, NamesWhatIsWrong)
{
  using Options = shape::HexRemeshOptions;
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const Options good;
  shapetest::ExpectRefused<Options>(
    [&](const Options& options) { shape::RemeshHexahedra(sphere, options); }, good,
    { { &Options::CellSize, std::numeric_limits<double>::infinity(), { "CellSize is inf" } },
      { &Options::CellsOnLongestSide, -1, { "CellsOnLongestSide is -1" } },
      { &Options::PaddingLayers, 0, { "PaddingLayers is 0", "at least 1" } },
      { &Options::FeatureAngle, 181.0, { "FeatureAngle is 181", "(0, 180]" } } });
  shape::Mesh open = sphere;
  open.Triangles.conservativeResize(open.Triangles.rows() - 1, 3);
  EXPECT_REFUSED(shape::RemeshHexahedra(open, good), "open");
}
