#pragma once

#include "Mesh/Mesh.h"
#include "Tetrahedra/Tetrahedralize.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

// What tests measure of a solid of tetrahedra.
namespace shapetest
{

/// Returns the volume of a tetrahedron, with its sign.
inline double Volume(const shape::TetrahedralizeResult& solid, Eigen::Index i)
{
  const Eigen::RowVector3d a = solid.Points.row(solid.Tetrahedra(i, 0));
  const Eigen::RowVector3d u = solid.Points.row(solid.Tetrahedra(i, 1)) - a;
  const Eigen::RowVector3d v = solid.Points.row(solid.Tetrahedra(i, 2)) - a;
  const Eigen::RowVector3d w = solid.Points.row(solid.Tetrahedra(i, 3)) - a;
  return u.cross(v).dot(w) / 6.0;
}

/// Returns the volume of a region, and expects every tetrahedron to be positive.
inline double RegionVolume(const shape::TetrahedralizeResult& solid, int region)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < solid.Tetrahedra.rows(); ++i)
  {
    EXPECT_GT(Volume(solid, i), 0.0) << "tetrahedron " << i;
    sum += solid.RegionId(i) == region ? Volume(solid, i) : 0.0;
  }
  return sum;
}

/// The faces of only one tetrahedron, facing outwards.
inline shape::Mesh BoundaryOf(const shape::TetrahedralizeResult& solid)
{
  const int sides[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 2 } };
  std::map<std::array<int, 3>, std::pair<int, Eigen::RowVector3i>> faces;
  for (Eigen::Index i = 0; i < solid.Tetrahedra.rows(); ++i)
  {
    for (const auto& side : sides)
    {
      const Eigen::RowVector3i face(
        solid.Tetrahedra(i, side[0]), solid.Tetrahedra(i, side[1]), solid.Tetrahedra(i, side[2]));
      std::array<int, 3> key = { face(0), face(1), face(2) };
      std::sort(key.begin(), key.end());
      auto& entry = faces[key];
      ++entry.first;
      entry.second = face;
    }
  }
  shape::Mesh boundary{ solid.Points, Eigen::MatrixXi(0, 3) };
  for (const auto& [key, entry] : faces)
  {
    if (entry.first == 1)
    {
      boundary.Triangles.conservativeResize(boundary.Triangles.rows() + 1, 3);
      boundary.Triangles.bottomRows(1) = entry.second;
    }
  }
  return boundary;
}

} // namespace shapetest
