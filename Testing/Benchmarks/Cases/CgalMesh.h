#pragma once

#include "Mesh/Mesh.h"

#define CGAL_EIGEN3_ENABLED
#include <CGAL/Surface_mesh.h>

#include <vector>

// CGAL is a peer: GPL, which is why it is included here only.
namespace benchmark
{

template <typename Point>
CGAL::Surface_mesh<Point> ToCgal(const shape::Mesh& mesh)
{
  CGAL::Surface_mesh<Point> converted;
  std::vector<typename CGAL::Surface_mesh<Point>::Vertex_index> corners;
  for (const auto& point : mesh.Points.rowwise())
  {
    corners.push_back(converted.add_vertex({ point(0), point(1), point(2) }));
  }
  for (const auto& triangle : mesh.Triangles.rowwise())
  {
    converted.add_face(corners[triangle(0)], corners[triangle(1)], corners[triangle(2)]);
  }
  return converted;
}

} // namespace benchmark
