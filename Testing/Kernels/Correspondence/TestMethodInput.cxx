#include "Base/Errors.h"
#include "Correspondence/Private/MethodInput.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace
{

using Method = shape::CorrespondenceOptions::MethodType;

constexpr Method AllMethods[] = { Method::ReversibleHarmonic, Method::FunctionalMap,
  Method::GromovWasserstein, Method::HeatKernel, Method::BlendedIntrinsic, Method::CommonSphere,
  Method::CommonOrbifold, Method::WeightedAverages, Method::CommonBase };

const shape::Landmarks Four = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 3, 3 } };

void Require(const shape::Mesh& a, const shape::Mesh& b, Method method,
  const shape::Landmarks& landmarks = Four)
{
  shape::CorrespondenceOptions options;
  options.Method = method;
  shape::RequireMethodInput(a, b, landmarks, options);
}

/// Checks that methods other than `able` refuse with all `words`, and those do not.
void ExpectRefused(const shape::Mesh& a, const shape::Mesh& b, const std::set<Method>& able,
  const std::vector<std::string>& words, const shape::Landmarks& landmarks = Four)
{
  for (const Method method : AllMethods)
  {
    const std::string refusal = shapetest::Refusal([&] { Require(a, b, method, landmarks); });
    if (able.count(method) > 0)
    {
      EXPECT_EQ(refusal, "") << static_cast<int>(method);
    }
    else
    {
      EXPECT_TRUE(shapetest::HasWords(refusal, words)) << static_cast<int>(method);
    }
  }
}

} // namespace

TEST(MethodInput, ASphereIsForAllMethods)
{
  const shape::Mesh sphere = shapetest::Pebble(shapetest::Icosphere(2));
  ExpectRefused(sphere, sphere, { std::begin(AllMethods), std::end(AllMethods) }, {});
  ExpectRefused(sphere, sphere, { std::begin(AllMethods), std::end(AllMethods) }, {}, {});
}

TEST(MethodInput, WhatTheOtherMethodsCanDoIsNamed)
{
  const shape::Mesh sphere = shapetest::Pebble(shapetest::Icosphere(2));
  ExpectRefused(sphere, shapetest::FlatDisk(4),
    { Method::ReversibleHarmonic, Method::FunctionalMap, Method::GromovWasserstein,
      Method::HeatKernel, Method::BlendedIntrinsic, Method::WeightedAverages },
    { "SurfaceB has 1 open loop", "Fill Holes", "or take ReversibleHarmonic" });
  ExpectRefused(shapetest::Torus(1.0, 0.3, 20, 10), sphere,
    { Method::ReversibleHarmonic, Method::FunctionalMap, Method::GromovWasserstein,
      Method::HeatKernel, Method::WeightedAverages },
    { "SurfaceA has genus 1", "ReversibleHarmonic" });
  const shape::Mesh two =
    shapetest::Joined({ sphere, shapetest::Shifted(shapetest::Icosphere(0), { 9, 9, 9 }) });
  ExpectRefused(two, sphere, { Method::FunctionalMap, Method::HeatKernel },
    { "SurfaceA has 2 components (the second begins at point 162)", "or take FunctionalMap" });
  ExpectRefused(sphere, two, {}, { "SurfaceB has 2 components", "Landmarks on each" }, {});
}

TEST(MethodInput, TrianglesThatDoNotHangTogetherAreTooManyComponents)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  shape::Mesh soup{ Eigen::MatrixXd(3 * sphere.Triangles.rows(), 3), sphere.Triangles };
  for (int t = 0; t < static_cast<int>(sphere.Triangles.rows()); ++t)
  {
    soup.Points.middleRows(3 * t, 3) = shape::GetCorners(sphere, t);
    soup.Triangles.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
  }
  ExpectRefused(soup, sphere, { Method::HeatKernel },
    { "SurfaceA has 320 components", "merge coincident points with Clean" });
}

TEST(MethodInput, LandmarksMustBeAsManyAsTheMethodTakes)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const shape::Landmarks one = { { 0, 5 } },
                         five = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 3, 3 }, { 4, 4 } };
  for (const Method method : { Method::BlendedIntrinsic, Method::CommonSphere })
  {
    EXPECT_REFUSED(Require(sphere, sphere, method, one), "there is 1 distinct landmark");
  }
  for (const Method method : { Method::CommonOrbifold, Method::WeightedAverages })
  {
    EXPECT_REFUSED(Require(sphere, sphere, method, one), "give three or more");
    EXPECT_NO_THROW(Require(sphere, sphere, method, five));
  }
  EXPECT_NO_THROW(Require(sphere, sphere, Method::FunctionalMap, one));
  EXPECT_REFUSED(Require(sphere, sphere, Method::CommonBase, { { 0, 0 }, { 1, 1 } }), "needs 3");
  const shape::Mesh torus = shapetest::Torus(1.0, 0.3, 20, 10);
  EXPECT_REFUSED(Require(torus, torus, Method::CommonBase, one), "needs 2");
  EXPECT_NO_THROW(Require(torus, torus, Method::CommonBase, five));
  EXPECT_REFUSED(Require(sphere, sphere, Method::CommonSphere, { { 0, 162 } }), "is point 162");
}

TEST(MethodInput, OneThatFacesInwardsOrHasNoAreaIsForNone)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  shape::Mesh inside = sphere;
  inside.Triangles.col(0).swap(inside.Triangles.col(1));
  ExpectRefused(sphere, inside, {}, { "SurfaceB faces inwards and SurfaceA outwards" });
  ExpectRefused(inside, sphere, {}, { "SurfaceA faces inwards and SurfaceB outwards" });
  ExpectRefused(inside, inside, { std::begin(AllMethods), std::end(AllMethods) }, {});
  shape::Mesh flat = sphere;
  flat.Points.rightCols(2).setZero();
  ExpectRefused(flat, sphere, {}, { "SurfaceA has no area" });
}
