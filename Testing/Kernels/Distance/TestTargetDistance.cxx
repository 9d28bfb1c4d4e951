#include "Base/Errors.h"
#include "Distance/TargetDistance.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace
{

shape::Mesh Joined(const std::vector<shape::Mesh>& parts)
{
  shape::Mesh all{ Eigen::MatrixXd(0, 3), Eigen::MatrixXi(0, 3) };
  for (const shape::Mesh& part : parts)
  {
    const auto points = static_cast<int>(all.Points.rows());
    all.Points.conservativeResize(points + part.Points.rows(), 3);
    all.Points.bottomRows(part.Points.rows()) = part.Points;
    all.Triangles.conservativeResize(all.Triangles.rows() + part.Triangles.rows(), 3);
    all.Triangles.bottomRows(part.Triangles.rows()) = part.Triangles.array() + points;
  }
  return all;
}

std::string Refusal(const shape::Mesh& boundary, const shape::Mesh& target)
{
  try
  {
    shape::ComputeTargetDistance(boundary, boundary.Points, target);
  }
  catch (const shape::InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

shape::Mesh Moved(shape::Mesh mesh, double x)
{
  mesh.Points.col(0).array() += x;
  return mesh;
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
  EXPECT_EQ(Refusal(torus, sphere)
              .rfind("the Boundary has 1 component of genus 1 and the Target "
                     "has 1 component of genus 0",
                0),
    0u)
    << Refusal(torus, sphere);
  EXPECT_EQ(
    Refusal(Joined({ sphere, Moved(torus, 5.0) }), Joined({ torus, Moved(sphere, 5.0) })), "");
  EXPECT_NE(
    Refusal(Joined({ sphere, Moved(torus, 5.0) }), sphere).find("genus 0, 1"), std::string::npos);
  shape::Mesh open = sphere;
  open.Triangles.conservativeResize(open.Triangles.rows() - 1, 3);
  EXPECT_NE(Refusal(sphere, open).find("the Target has 1 open loop"), std::string::npos);
  EXPECT_NE(Refusal(open, sphere).find("the Boundary has 1 open loop"), std::string::npos);
}
