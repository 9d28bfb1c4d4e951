#pragma once

#include "Mesh/Mesh.h"
#include "Support/TestShapes.h"

#include <vector>

// Spheres, boxes and surfaces of several components.
namespace shapetest
{

inline shape::Mesh Shifted(shape::Mesh mesh, const Eigen::RowVector3d& shift)
{
  mesh.Points.rowwise() += shift;
  return mesh;
}

/// An icosphere of this radius around a centre.
inline shape::Mesh Sphere(
  int level, double radius, const Eigen::RowVector3d& centre = Eigen::RowVector3d::Zero())
{
  shape::Mesh sphere = Icosphere(level);
  sphere.Points *= radius;
  return Shifted(sphere, centre);
}

/// An axis-aligned box in 12 triangles.
inline shape::Mesh Box(const Eigen::RowVector3d& low, const Eigen::RowVector3d& high)
{
  shape::Mesh box{ Eigen::MatrixXd(8, 3), Eigen::MatrixXi(12, 3) };
  for (int i = 0; i < 8; ++i)
  {
    box.Points.row(i) << (i & 1 ? high : low)(0), (i & 2 ? high : low)(1), (i & 4 ? high : low)(2);
  }
  box.Triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6,
    0, 6, 2, 1, 3, 7, 1, 7, 5;
  return box;
}

/// Facing the other way.
inline shape::Mesh Reversed(shape::Mesh mesh)
{
  mesh.Triangles.col(1).swap(mesh.Triangles.col(2));
  return mesh;
}

/// Splits a triangle at the middle of the edge that begins at `corner`. The triangle beyond keeps
/// its edge: a triangle without area lies between them. Its new point is last.
inline shape::Mesh WithFlatTriangle(shape::Mesh mesh, int triangle, int corner)
{
  const int a = mesh.Triangles(triangle, corner), b = mesh.Triangles(triangle, (corner + 1) % 3),
            c = mesh.Triangles(triangle, (corner + 2) % 3),
            middle = static_cast<int>(mesh.Points.rows());
  const Eigen::RowVector3d position = 0.5 * (mesh.Points.row(a) + mesh.Points.row(b));
  mesh.Points.conservativeResize(middle + 1, 3);
  mesh.Points.row(middle) = position;
  const Eigen::Index count = mesh.Triangles.rows();
  mesh.Triangles.conservativeResize(count + 2, 3);
  mesh.Triangles.row(triangle) << a, middle, c;
  mesh.Triangles.row(count) << middle, b, c;
  mesh.Triangles.row(count + 1) << a, b, middle;
  return mesh;
}

/// Several surfaces as one, which shares no point among them.
inline shape::Mesh Joined(const std::vector<shape::Mesh>& parts)
{
  shape::Mesh all{ Eigen::MatrixXd(0, 3), Eigen::MatrixXi(0, 3) };
  for (const shape::Mesh& part : parts)
  {
    const Eigen::Index points = all.Points.rows(), triangles = all.Triangles.rows();
    all.Points.conservativeResize(points + part.Points.rows(), 3);
    all.Points.bottomRows(part.Points.rows()) = part.Points;
    all.Triangles.conservativeResize(triangles + part.Triangles.rows(), 3);
    all.Triangles.bottomRows(part.Triangles.rows()) =
      part.Triangles.array() + static_cast<int>(points);
  }
  return all;
}

/// A surface and a copy of it, moved by `shift`.
inline shape::Mesh Twice(
  const shape::Mesh& mesh, const Eigen::RowVector3d& shift = Eigen::RowVector3d::Constant(5.0))
{
  return Joined({ mesh, Shifted(mesh, shift) });
}

/// Without its last triangles.
inline shape::Mesh WithoutLast(shape::Mesh mesh, int count = 1)
{
  mesh.Triangles.conservativeResize(mesh.Triangles.rows() - count, 3);
  return mesh;
}

} // namespace shapetest
