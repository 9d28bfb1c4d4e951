// Facts checked: normals at points are the sphere's on a sphere, do not depend on how the triangles
// around a point are cut, and are finite where triangles have no area.

#include "Geometry/VertexNormals.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(VertexNormals, OfASphereAreItsRadii)
{
  const shape::Mesh sphere = shapetest::Icosphere(4);
  const Eigen::MatrixXd off =
    shape::ComputeVertexNormals(sphere, shape::NormalWeight::Angle) - sphere.Points;
  EXPECT_LT(off.rowwise().norm().maxCoeff(), 3e-3);
}

TEST(VertexNormals, DoNotDependOnHowTrianglesAreCut)
{
  shape::Mesh corner;
  corner.Points.resize(5, 3);
  corner.Points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.7, 0.3, 0;
  corner.Triangles.resize(3, 3);
  corner.Triangles << 0, 2, 1, 0, 3, 2, 0, 1, 3;
  const Eigen::RowVector3d whole =
    shape::ComputeVertexNormals(corner, shape::NormalWeight::Angle).row(0);
  EXPECT_LT((whole + Eigen::RowVector3d::Constant(1.0 / std::sqrt(3.0))).norm(), 1e-15);
  corner.Triangles.resize(4, 3);
  corner.Triangles << 0, 2, 4, 0, 4, 1, 0, 3, 2, 0, 1, 3;
  EXPECT_LT(
    (shape::ComputeVertexNormals(corner, shape::NormalWeight::Angle).row(0) - whole).norm(), 1e-15);
}

TEST(VertexNormals, AreZeroWhereNoAreaIs)
{
  shape::Mesh flat;
  flat.Points.resize(6, 3);
  flat.Points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 0, 0, 0, 1e-100, 0, 5, 5, 5;
  flat.Triangles.resize(2, 3);
  flat.Triangles << 0, 1, 2, 0, 1, 4;
  const shape::Surface surface = flat;
  const Eigen::MatrixXd& normals = shape::GetVertexNormals(surface);
  EXPECT_TRUE(normals.allFinite());
  EXPECT_EQ(normals.row(2).norm(), 0.0); // of the triangle without area alone
  EXPECT_EQ(normals.row(5).norm(), 0.0); // of none
  EXPECT_EQ(normals(0, 2), 1.0);         // however thin
}
