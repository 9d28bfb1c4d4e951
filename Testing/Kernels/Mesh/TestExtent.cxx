#include "Mesh/Extent.h"

#include "Support/Refusals.h"

#include <gtest/gtest.h>

namespace
{

/// A triangle with sides of 3, 4 and 5, and a point far away that it does not use.
shape::Mesh RightTriangle()
{
  shape::Mesh mesh;
  mesh.Points.resize(4, 3);
  mesh.Points << 1.0, 2.0, 3.0, 4.0, 2.0, 3.0, 1.0, 6.0, 3.0, 100.0, 100.0, 100.0;
  mesh.Triangles.resize(1, 3);
  mesh.Triangles << 0, 1, 2;
  return mesh;
}

} // namespace

TEST(Extent, IsThatOfTheUsedPoints)
{
  const shape::Mesh mesh = RightTriangle();
  EXPECT_EQ(shape::ComputeLongestBoxEdge(mesh), 4.0);
  EXPECT_EQ(shape::ComputeBoxDiagonal(mesh), 5.0);
  EXPECT_EQ(shape::ComputeMeanEdgeLength(mesh), 4.0);
}

TEST(Extent, RefusesLengthsThatCannotBeComputedWith)
{
  shape::Mesh mesh = RightTriangle();
  shape::RequireExtent(mesh, "it");
  mesh.Points *= 1e50;
  EXPECT_TRUE(shapetest::HasWords(shapetest::Refusal([&] { shape::RequireExtent(mesh, "it"); }),
    { "it has a longest side of 4e+50", "scale it" }));
  mesh = RightTriangle();
  mesh.Points.array() += 1e14;
  EXPECT_TRUE(shapetest::HasWords(shapetest::Refusal([&] { shape::RequireExtent(mesh, "it"); }),
    { "it is only 4 long", "move it to the origin" }));
}
