#include "Base/Errors.h"
#include "Distance/TargetDistance.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <string>

namespace
{

double Distance(const shape::Mesh& boundary, const shape::Mesh& target)
{
  return shape::ComputeTargetDistance(boundary, boundary.Points, target);
}

shape::Mesh SideBySide(const shape::Mesh& one, const shape::Mesh& other)
{
  return shapetest::Joined({ one, shapetest::Shifted(other, { 5, 0, 0 }) });
}

} // namespace

TEST(TargetDistance, OfConcentricSpheresIsTheDifferenceOfTheirRadii)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  EXPECT_NEAR(shape::ComputeTargetDistance(sphere, sphere.Points, sphere), 0.0, 1e-15);
  // Points beyond a corner of the target are closest to that corner.
  EXPECT_NEAR(shape::ComputeTargetDistance(sphere, 1.5 * sphere.Points, sphere), 0.25, 1e-4);
}

TEST(TargetDistance, ComponentsMustHaveTheSameGenera)
{
  const shape::Mesh sphere = shapetest::Icosphere(1), torus = shapetest::Torus(1.0, 0.3, 16, 8);
  const std::string refusal = shapetest::Refusal([&] { Distance(torus, sphere); });
  EXPECT_EQ(refusal.rfind("the Boundary has 1 component of genus 1 and the Target "
                          "has 1 component of genus 0",
              0),
    0u)
    << refusal;
  EXPECT_NO_THROW(Distance(SideBySide(sphere, torus), SideBySide(torus, sphere)));
  EXPECT_REFUSED(Distance(SideBySide(sphere, torus), sphere), "genus 0, 1");
  const shape::Mesh open = shapetest::WithoutLast(sphere);
  EXPECT_REFUSED(Distance(sphere, open), "the Target has 1 open loop");
  EXPECT_REFUSED(Distance(open, sphere), "the Boundary has 1 open loop");
}
