#pragma once

#include "Geodesics/SurfacePath.h"
#include "Mesh/Mesh.h"
#include "Mesh/SurfacePoints.h"

#include <gtest/gtest.h>

#include <cstddef>

// What holds for every path on a surface.
namespace shapetest
{

inline Eigen::RowVector3d PositionOf(const shape::Mesh& mesh, const shape::SurfacePoint& position)
{
  return position.Barycentric * shape::GetCorners(mesh, position.Triangle);
}

/// That every stretch lies in its triangle, and that they are as long as the path together.
inline void ExpectPath(const shape::Mesh& mesh, const shape::SurfacePath& path)
{
  ASSERT_EQ(path.Positions.size(), path.Triangles.size() + 1);
  double length = 0.0;
  for (std::size_t i = 0; i < path.Triangles.size(); ++i)
  {
    for (const shape::SurfacePoint& end : { path.Positions[i], path.Positions[i + 1] })
    {
      for (int k = 0; k < 3; ++k)
      {
        const int point = mesh.Triangles(end.Triangle, k);
        ASSERT_TRUE(end.Barycentric(k) == 0.0 ||
          (mesh.Triangles.row(path.Triangles[i]).array() == point).any());
      }
    }
    length +=
      (PositionOf(mesh, path.Positions[i + 1]) - PositionOf(mesh, path.Positions[i])).norm();
  }
  EXPECT_NEAR(path.Length, length, 1e-12 * length);
}

} // namespace shapetest
