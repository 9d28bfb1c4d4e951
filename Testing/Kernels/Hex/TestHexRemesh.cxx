#include "Hex/HexRemesh.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfaceWork.h"
#include "Mesh/Topology.h"
#include "Quality/ScaledJacobian.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

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

namespace
{

/// A cylinder of radius 1 along z from `bottom`, one unit high.
shape::Mesh Cylinder(double bottom)
{
  std::vector<Eigen::RowVector2d> circle;
  for (int i = 0; i < 48; ++i)
  {
    circle.emplace_back(std::cos(i * M_PI / 24.0), std::sin(i * M_PI / 24.0));
  }
  return shapetest::Shifted(shapetest::Prism(circle), { 0.0, 0.0, bottom });
}

/// The ends of cylinders along z are patches 4 and 5, and the halves of their sides 7 and 8.
Eigen::VectorXi PatchesOf(const shape::Surface& cylinders)
{
  const Eigen::VectorXd across = shape::ComputeCentroids(cylinders).col(1);
  const Eigen::VectorXd up = cylinders.AreaVectors().rowwise().normalized().col(2);
  Eigen::VectorXi patches(up.size());
  for (Eigen::Index t = 0; t < up.size(); ++t)
  {
    patches(t) = std::abs(up(t)) > 0.5 ? (up(t) < 0.0 ? 4 : 5) : (across(t) < 0.0 ? 7 : 8);
  }
  return patches;
}

} // namespace

TEST(HexRemesh, GivenPatchesArePatchesOfTheBoundaryWithTheirNumbers)
{
  const shape::Surface one = Cylinder(0.0),
                       two = shapetest::Joined({ Cylinder(0.0), Cylinder(1.5) });
  for (const shape::Surface& surface : { one, two })
  {
    for (const MethodType method : { MethodType::Grid, MethodType::Polycube })
    {
      if (method == MethodType::Polycube && surface.Topology().Components > 1)
      {
        continue; // a polycube has one component
      }
      shape::HexRemeshOptions options;
      options.Method = method;
      options.CellSize = 0.2;
      options.Patches = PatchesOf(surface);
      const shape::HexFit fit = shape::RemeshHexahedra(surface, options).Fit;
      ASSERT_TRUE(fit.CreasesKept);
      EXPECT_GT(fit.MinimumScaledJacobian, 0.2);
      EXPECT_LT(fit.Creases.Distance, 0.02);
      EXPECT_EQ(
        std::set<int>(fit.PatchOf.begin(), fit.PatchOf.end()), (std::set<int>{ 4, 5, 7, 8 }));
      const Eigen::MatrixXd centres = shape::ComputeQuadCentres(fit.Solid.Points, fit.Quads);
      for (Eigen::Index q = 0; q < centres.rows(); ++q)
      {
        const double side = fit.PatchOf(q) == 7 ? -1.0 : fit.PatchOf(q) == 8 ? 1.0 : 0.0;
        const bool isEnd = std::abs(centres(q, 2) - std::round(2.0 * centres(q, 2)) / 2.0) < 1e-9;
        EXPECT_TRUE(side == 0.0 ? isEnd : side * centres(q, 1) > 0.0) << centres.row(q);
      }
    }
  }
}

TEST(HexRemesh, RefusesPatchesThatDoNotFit)
{
  const shape::Surface cylinder = Cylinder(0.0);
  shape::HexRemeshOptions options;
  options.Patches = Eigen::VectorXi::Zero(5);
  EXPECT_REFUSED(shape::RemeshHexahedra(cylinder, options), "5 patches", "one for each");
  options.Patches = PatchesOf(cylinder);
  options.Patches(3) = -2;
  EXPECT_REFUSED(shape::RemeshHexahedra(cylinder, options), "triangle 3 is -2", "from 0");
  const shape::Surface crossing = shapetest::Joined({ Cylinder(0.0), Cylinder(0.5) });
  options.Patches = PatchesOf(crossing);
  EXPECT_REFUSED(shape::RemeshHexahedra(crossing, options), "intersects itself", "Shape Solidify");
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

TEST(HexRemesh, ADraftIsValid)
{
  // None of these was used to choose what a draft leaves out.
  for (const char* name : { "joint", "hand", "elephant" })
  {
    const shape::Mesh surface = shapetest::ReadModel(name);
    shape::HexRemeshOptions options;
    options.Draft = true;
    const shape::HexRemeshResult result = shape::RemeshHexahedra(surface, options);
    const shape::Topology wanted = shape::RequireClosedSurface(surface, name);
    const shape::Topology found = BoundaryTopology(result.Fit);
    EXPECT_EQ(found.EulerNumber, wanted.EulerNumber) << name;
    EXPECT_EQ(found.Components, wanted.Components) << name;
    EXPECT_GT(shape::ComputeScaledJacobians(result.Fit.Solid).minCoeff(), 0.0) << name;
    EXPECT_NE(result.Reason.find("draft"), std::string::npos) << result.Reason;
  }
}

TEST(HexRemesh, ADraftNeedsAGrid)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  shape::HexRemeshOptions options;
  options.Draft = true;
  options.Method = MethodType::Polycube;
  EXPECT_REFUSED(shape::RemeshHexahedra(sphere, options), "Draft", "Method");
}

TEST(HexRemesh, ASurfaceThatAPolycubeCannotFollowIsFilledByAGoodGrid)
{
  shape::HexRemeshOptions options;
  options.CellSize = 0.2;
  const shape::HexRemeshResult sphere = shape::RemeshHexahedra(shapetest::Icosphere(4), options);
  EXPECT_EQ(sphere.Method, MethodType::Grid) << sphere.Reason;
  EXPECT_GE(sphere.Fit.MinimumScaledJacobian, 0.55);
  const shape::HexRemeshResult box =
    shape::RemeshHexahedra(shapetest::Box({ -1.0, -1.0, -1.0 }, { 1.0, 1.0, 1.0 }), options);
  EXPECT_EQ(box.Method, MethodType::Polycube) << box.Reason;
}
