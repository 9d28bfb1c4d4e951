#include "Base/Errors.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"
#include "Support/TetrahedralSolids.h"
#include "Tetrahedra/Private/TetGen.h"
#include "Tetrahedra/Tetrahedralize.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace
{

using shapetest::BoundaryOf;
using shapetest::Box;
using shapetest::Icosphere;
using shapetest::Joined;
using shapetest::RegionVolume;
using shapetest::Sphere;
using shapetest::Volume;

/// Triangles as sorted corner triples that start at the least corner.
std::vector<std::array<int, 3>> Rotated(const Eigen::MatrixXi& triangles)
{
  std::vector<std::array<int, 3>> all;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    std::array<int, 3> corners = { triangles(t, 0), triangles(t, 1), triangles(t, 2) };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    all.push_back(corners);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Ten million tetrahedra are asked for.
shape::TetrahedralizeOptions MinutesOfWork()
{
  shape::TetrahedralizeOptions options;
  options.MaximumVolume = 4e-7;
  return options;
}

} // namespace

TEST(Tetrahedralize, TheBoundaryIsTheSurfaceAndTheVolumeItsVolume)
{
  for (const shape::Mesh& mesh : { Box({ 0, 0, 0 }, { 1, 2, 3 }), Icosphere(3),
         shapetest::Torus(1.0, 0.3, 24, 12), Sphere(2, 1e-7, { 3e-6, 0, 0 }), Sphere(2, 1e9) })
  {
    const shape::TetrahedralizeResult solid = shape::Tetrahedralize(mesh);
    const double volume = shape::ComputeEnclosedVolume(mesh);
    EXPECT_NEAR(RegionVolume(solid, 0), volume, 1e-12 * volume);
    EXPECT_NEAR(solid.Volume, volume, 1e-12 * volume);
    // The input's points come first, as they were, and its triangles are the boundary, facing out.
    EXPECT_EQ(solid.Points.topRows(mesh.Points.rows()), mesh.Points);
    EXPECT_EQ(Rotated(BoundaryOf(solid).Triangles), Rotated(mesh.Triangles));
    for (Eigen::Index i = 0; i < solid.Points.rows(); ++i)
    {
      EXPECT_EQ(solid.Provenance.Points(i), i < mesh.Points.rows() ? i : -1);
    }
    EXPECT_EQ(solid.SteinerPoints, solid.Points.rows() - mesh.Points.rows());
    EXPECT_EQ(solid.Regions, 1);
    EXPECT_GT(solid.MinimumScaledJacobian, 0.0);
  }
}

TEST(Tetrahedralize, AFacedCornerHasItsKnownScaledJacobian)
{
  shape::Mesh corner{ Eigen::MatrixXd(4, 3), Eigen::MatrixXi(4, 3) };
  corner.Points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  corner.Triangles << 0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2;
  shape::TetrahedralizeOptions options;
  options.MaximumRadiusEdgeRatio = 0.0;
  const shape::TetrahedralizeResult solid = shape::Tetrahedralize(corner, {}, options);
  ASSERT_EQ(solid.Tetrahedra.rows(), 1);
  EXPECT_NEAR(solid.MinimumScaledJacobian, std::sqrt(0.5), 1e-15);
}

TEST(Tetrahedralize, ASurfaceThatFacesInwardsIsTheSameSolid)
{
  shape::Mesh mesh = Icosphere(2);
  mesh.Triangles.col(0).swap(mesh.Triangles.col(1));
  EXPECT_NEAR(shape::Tetrahedralize(mesh).Volume, -shape::ComputeEnclosedVolume(mesh), 1e-12);
}

TEST(Tetrahedralize, MaximumVolumeAndRadiusEdgeRatioBoundEveryTetrahedron)
{
  shape::TetrahedralizeOptions options;
  options.PreserveBoundary = false;
  options.MaximumVolume = 0.002;
  options.MaximumRadiusEdgeRatio = 1.5;
  const shape::Mesh box = Box({ 0, 0, 0 }, { 1, 1, 1 });
  const shape::TetrahedralizeResult solid = shape::Tetrahedralize(box, {}, options);
  EXPECT_GT(solid.Tetrahedra.rows(), 500);
  EXPECT_NEAR(RegionVolume(solid, 0), 1.0, 1e-12);
  for (Eigen::Index i = 0; i < solid.Tetrahedra.rows(); ++i)
  {
    EXPECT_LE(Volume(solid, i), 1.1 * options.MaximumVolume);
    // |c - a|^2 = |c - b|^2 for each other corner b: three equations for the circumcentre c.
    Eigen::Matrix3d edges;
    Eigen::Vector3d halfSquares;
    double shortest = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 4; ++a)
    {
      for (int b = a + 1; b < 4; ++b)
      {
        const Eigen::RowVector3d edge =
          solid.Points.row(solid.Tetrahedra(i, b)) - solid.Points.row(solid.Tetrahedra(i, a));
        shortest = std::min(shortest, edge.norm());
        if (a == 0)
        {
          edges.row(b - 1) = edge;
          halfSquares(b - 1) = 0.5 * edge.squaredNorm();
        }
      }
    }
    EXPECT_LE(edges.inverse().operator*(halfSquares).norm() / shortest, 1.5 + 1e-9);
  }
  // Points are added on the sides, which stay where they are.
  const shape::Mesh boundary = BoundaryOf(solid);
  EXPECT_GT(boundary.Triangles.rows(), 12);
  EXPECT_EQ(shape::RequireClosedSurface(boundary, "the boundary").EulerNumber, 2);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(boundary), 1.0, 1e-12);
  EXPECT_EQ(solid.Points.topRows(8), box.Points);
}

TEST(Tetrahedralize, InnerSurfacesAreRegionsAlsoInsideOneAnother)
{
  // Given in an order that is not that of their nesting, and one beside the others.
  const std::vector<shape::Surface> inner = { Sphere(2, 0.3), Sphere(2, 0.6),
    Sphere(1, 0.1, { 0.8, 0, 0 }) };
  const shape::Mesh outer = Icosphere(3);
  for (const bool preserve : { true, false })
  {
    shape::TetrahedralizeOptions options;
    options.PreserveBoundary = preserve;
    const shape::TetrahedralizeResult solid = shape::Tetrahedralize(outer, inner, options);
    double v[3];
    for (int i = 0; i < 3; ++i)
    {
      v[i] = shape::ComputeEnclosedVolume(inner[i]);
    }
    EXPECT_EQ(solid.Regions, 4);
    EXPECT_NEAR(RegionVolume(solid, 0), shape::ComputeEnclosedVolume(outer) - v[1] - v[2], 1e-12);
    EXPECT_NEAR(RegionVolume(solid, 1), v[0], 1e-12);
    EXPECT_NEAR(RegionVolume(solid, 2), v[1] - v[0], 1e-12);
    EXPECT_NEAR(RegionVolume(solid, 3), v[2], 1e-12);
    // The inner surfaces' points follow the outer one's.
    EXPECT_EQ(
      solid.Points.middleRows(outer.Points.rows(), inner[0].Points().rows()), inner[0].Points());
  }
}

TEST(Tetrahedralize, AComponentInsideAnotherIsAVoidAndTheNextOneSolidAgain)
{
  const std::vector<shape::Mesh> parts = { Sphere(2, 0.7), Icosphere(3), Sphere(2, 0.4),
    Sphere(1, 0.2), Sphere(2, 0.5, { 3, 0, 0 }) };
  const shape::TetrahedralizeResult solid = shape::Tetrahedralize(Joined(parts));
  double volume = 0.0;
  const double signs[] = { -1, 1, 1, -1, 1 };
  for (int i = 0; i < 5; ++i)
  {
    volume += signs[i] * shape::ComputeEnclosedVolume(parts[i]);
  }
  EXPECT_NEAR(RegionVolume(solid, 0), volume, 1e-12);
  const shape::Mesh boundary = BoundaryOf(solid);
  const shape::Topology topology = shape::RequireClosedSurface(boundary, "the boundary");
  EXPECT_EQ(topology.Components, 5);
  EXPECT_EQ(topology.EulerNumber, 10);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(boundary), volume, 1e-12);
}

TEST(Tetrahedralize, AVoidInsideAnInnerSurfaceAndAHollowInnerSurface)
{
  // The boundary's own void lies inside inner surface 0; inner surface 1 is a shell.
  const shape::Mesh boundary = Joined({ Sphere(3, 2.0), Sphere(1, 0.2, { -1, 0, 0 }) });
  const shape::Mesh solidBoundary = Sphere(2, 0.5, { -1, 0, 0 });
  const shape::Mesh shell = Joined({ Sphere(2, 0.5, { 1, 0, 0 }), Sphere(2, 0.3, { 1, 0, 0 }) });
  const shape::TetrahedralizeResult solid =
    shape::Tetrahedralize(boundary, { solidBoundary, shell });
  const double small = shape::ComputeEnclosedVolume(Sphere(1, 0.2));
  const double half = shape::ComputeEnclosedVolume(Sphere(2, 0.5));
  const double hollow = shape::ComputeEnclosedVolume(Sphere(2, 0.3));
  EXPECT_NEAR(RegionVolume(solid, 1), half - small, 1e-12);
  EXPECT_NEAR(RegionVolume(solid, 2), half - hollow, 1e-12);
  EXPECT_NEAR(RegionVolume(solid, 0),
    shape::ComputeEnclosedVolume(Sphere(3, 2.0)) - 2.0 * half + hollow, 1e-11);
}

TEST(Tetrahedralize, UnusedAndCoincidentPointsAreLeftOut)
{
  // Two boxes that touch at a corner, which each has as a point of its own, and a point of nobody.
  shape::Mesh mesh = Joined({ Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 1, 1, 1 }, { 2, 2, 2 }) });
  mesh.Points.conservativeResize(17, 3);
  mesh.Points.row(16) << 0.5, 0.5, 0.5;
  shape::TetrahedralizeOptions options;
  options.MaximumRadiusEdgeRatio = 0.0;
  const shape::TetrahedralizeResult solid = shape::Tetrahedralize(mesh, {}, options);
  EXPECT_NEAR(RegionVolume(solid, 0), 2.0, 1e-12);
  EXPECT_EQ(solid.Points.rows() - solid.SteinerPoints, 15);
  for (Eigen::Index i = 0; i < 15; ++i)
  {
    EXPECT_EQ(solid.Provenance.Points(i), i < 8 ? i : i + 1);
    EXPECT_EQ(solid.Points.row(i), mesh.Points.row(solid.Provenance.Points(i)));
  }
}

TEST(Tetrahedralize, ComputesTheSameBitsAgain)
{
  const shape::Mesh mesh = shapetest::Torus(1.0, 0.4, 20, 10);
  const shape::TetrahedralizeResult a = shape::Tetrahedralize(mesh),
                                    b = shape::Tetrahedralize(mesh);
  EXPECT_EQ(a.Points, b.Points);
  EXPECT_EQ(a.Tetrahedra, b.Tetrahedra);
}

TEST(Tetrahedralize, BadSurfacesAreNamed)
{
  shape::Mesh sphere = Icosphere(2);
  const shape::Mesh open = shapetest::WithoutLast(sphere);
  EXPECT_REFUSED(shape::Tetrahedralize(open), "the Input has 1 open loop");
  EXPECT_REFUSED(
    shape::Tetrahedralize(Sphere(3, 2.0), { open }), "inner surface 0 has 1 open loop");
  shape::Mesh spoiled = sphere;
  spoiled.Points(17, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(
    shape::Tetrahedralize(spoiled), "1 point with a value that is not finite (first at point 17)");
  // Closed in space, but every triangle has its own points.
  shape::Mesh soup{ Eigen::MatrixXd(sphere.Triangles.size(), 3), sphere.Triangles };
  for (Eigen::Index t = 0; t < sphere.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      soup.Points.row(3 * t + k) = sphere.Points.row(sphere.Triangles(t, k));
      soup.Triangles(t, k) = static_cast<int>(3 * t + k);
    }
  }
  EXPECT_REFUSED(
    shape::Tetrahedralize(soup), "only because 798 of its points coincide with others");
  EXPECT_REFUSED(
    shape::Tetrahedralize({ sphere.Points, Eigen::MatrixXi(0, 3) }), "has no triangles");
  // A point in the middle of an edge makes a triangle without area.
  shape::Mesh flat = Box({ 0, 0, 0 }, { 1, 1, 1 });
  flat.Points.conservativeResize(9, 3);
  flat.Points.row(8) << 0.5, 0.5, 0.0;
  flat.Triangles.conservativeResize(14, 3);
  flat.Triangles.row(0) << 0, 2, 8;
  flat.Triangles.row(12) << 2, 3, 8;
  flat.Triangles.row(13) << 0, 8, 3;
  EXPECT_REFUSED(
    shape::Tetrahedralize(flat), "1 triangle without area (first triangle 13 near (0.5");
  // Flattened onto a plane.
  shape::Mesh plane = sphere;
  plane.Points.col(2).setZero();
  EXPECT_THROW(shape::Tetrahedralize(plane), shape::InvalidInput);
}

TEST(Tetrahedralize, CrossingsAreCountedAndPlaced)
{
  // Two boxes through each other in the middle.
  const shape::Mesh crossed =
    Joined({ Box({ 0, 0, 0 }, { 1, 1, 1 }), Box({ 0.25, 0.25, 0.5 }, { 0.75, 0.75, 2.5 }) });
  EXPECT_REFUSED(shape::Tetrahedralize(crossed), "the Input crosses or touches itself at ",
    "2 and 16 near (", ", 1)");
  EXPECT_REFUSED(shape::Tetrahedralize(Icosphere(2), { Sphere(2, 0.5, { 0.8, 0, 0 }) }),
    "inner surface 0 crosses or touches the Input");
  EXPECT_REFUSED(
    shape::Tetrahedralize(Sphere(2, 2.0), { Sphere(2, 0.5), Sphere(2, 0.5, { 0.1, 0, 0 }) }),
    "inner surface 1 crosses or touches inner surface 0");
  EXPECT_REFUSED(shape::Tetrahedralize(Sphere(2, 2.0), { Sphere(2, 0.5), Sphere(2, 0.5) }),
    "inner surface 1 crosses or touches inner surface 0");
  EXPECT_REFUSED(shape::Tetrahedralize(Icosphere(2), { Sphere(1, 0.1, { 3, 0, 0 }) }),
    "inner surface 0 lies outside the solid that the Input bounds");
  EXPECT_REFUSED(
    shape::Tetrahedralize(Joined({ Icosphere(2), Sphere(2, 0.5) }), { Sphere(1, 0.1) }),
    "inner surface 0 lies outside the solid");
}

TEST(Tetrahedralize, OptionsOutOfRangeAreNamed)
{
  using Options = shape::TetrahedralizeOptions;
  shapetest::ExpectRefused<Options>(
    [](const Options& options) { shape::Tetrahedralize(Icosphere(1), {}, options); }, {},
    { { &Options::MaximumRadiusEdgeRatio, 0.9, { "MaximumRadiusEdgeRatio is 0.9" } },
      { &Options::MaximumVolume, -1.0, { "MaximumVolume is -1" } },
      { &Options::MaximumVolume, 1e-12, { "more than 100 million" } } });
}

TEST(Tetrahedralize, AnAbortEndsTetGenAndLeavesNoProcess)
{
  int calls = 0;
  double last = 0.0;
  EXPECT_THROW(shape::Tetrahedralize(Icosphere(3), {}, MinutesOfWork(),
                 shape::Progress(
                   [&](double fraction)
                   {
                     EXPECT_GE(fraction, last);
                     last = fraction;
                     return ++calls < 20;
                   })),
    shape::Aborted);
  EXPECT_EQ(calls, 20);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
}

// Ten million tetrahedra need more than a second.
TEST(Tetrahedralize, TheTimeOfTetGenIsLimited)
{
  const shape::Mesh ball = Icosphere(3);
  const Eigen::MatrixXd none(0, 3);
  try
  {
    shape::RunTetGen({ ball, none, 2.0, MinutesOfWork().MaximumVolume, true, 100000000, 1 });
    FAIL();
  }
  catch (const shape::SolveFailure& failure)
  {
    EXPECT_NE(std::string(failure.what()).find("within 1 seconds"), std::string::npos);
  }
}

TEST(Tetrahedralize, TheNumberOfNewPointsIsLimited)
{
  shape::TetrahedralizeOptions options = MinutesOfWork();
  options.MaximumNewPoints = 1000;
  EXPECT_UNSOLVED(shape::Tetrahedralize(Icosphere(3), {}, options), "TetGen added 1000 points");
  options.MaximumNewPoints = -1;
  EXPECT_THROW(shape::Tetrahedralize(Icosphere(3), {}, options), shape::InvalidInput);
}

TEST(Tetrahedralize, ACrashOfTetGenIsAnError)
{
  // From outside, since no input is known to crash every build of TetGen.
  const auto fillAndSend = [](int signal)
  {
    shape::Tetrahedralize(Icosphere(3), {}, MinutesOfWork(),
      shape::Progress(
        [&](double)
        {
          const std::string self = std::to_string(getpid());
          pid_t child = 0;
          if (std::ifstream("/proc/" + self + "/task/" + self + "/children") >> child)
          {
            kill(child, signal);
          }
          return true;
        }));
  };
  EXPECT_UNSOLVED(fillAndSend(SIGSEGV), "TetGen crashed (Segmentation fault)");
  EXPECT_UNSOLVED(fillAndSend(SIGABRT), "TetGen stopped at an internal assertion");
  EXPECT_UNSOLVED(fillAndSend(SIGKILL), "memory ran out");
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
  EXPECT_GT(shape::Tetrahedralize(Icosphere(1)).Tetrahedra.rows(), 0) << "afterwards all is well";
}

TEST(Tetrahedralize, VeryThinSolidsAreFilled)
{
  shape::Mesh lens = Icosphere(1);
  lens.Points.col(2) *= 1e-9;
  EXPECT_NEAR(shape::Tetrahedralize(lens).Volume / shape::ComputeEnclosedVolume(lens), 1.0, 1e-9);
}

TEST(Tetrahedralize, WhatTetGenGivesUpOnIsAnError)
{
  // Spikes of lengths from 2^-25 to 2^25 around a centre: no two triangles cross, but TetGen's
  // arithmetic finds that some do.
  shape::Mesh star = Icosphere(2);
  for (int i = 0; i < star.Points.rows(); ++i)
  {
    star.Points.row(i) *= std::exp2(i * 8 % 51 - 25);
  }
  shape::TetrahedralizeOptions options;
  options.MaximumRadiusEdgeRatio = 0.0;
  EXPECT_UNSOLVED(
    shape::Tetrahedralize(star, {}, options), "TetGen treats parts of the surface as crossing");
}

TEST(Tetrahedralize, ScannedModelsAreFilledOrRefusedWithThePlace)
{
  const std::string folder = SHAPEMAP_MODELS;
  if (!std::ifstream(folder + "/man.off"))
  {
    GTEST_SKIP() << "no models in " << folder;
  }
  for (const char* name : { "elephant", "bear_bis", "femur", "triceratops", "rotor" })
  {
    const shape::Mesh mesh = shapetest::ReadOff(folder + "/" + name + ".off");
    const shape::TetrahedralizeResult solid = shape::Tetrahedralize(mesh);
    const double volume = std::abs(shape::ComputeEnclosedVolume(mesh));
    EXPECT_NEAR(solid.Volume, volume, 1e-10 * volume) << name;
    EXPECT_EQ(shape::ComputeTopology(BoundaryOf(solid)).EulerNumber,
      shape::ComputeTopology(mesh).EulerNumber)
      << name;
  }
  EXPECT_REFUSED(shape::Tetrahedralize(shapetest::ReadOff(folder + "/bull.off")),
    "the Input crosses or touches itself at 3 pairs of triangles (966 and 987 near (0.250854, ");
}
