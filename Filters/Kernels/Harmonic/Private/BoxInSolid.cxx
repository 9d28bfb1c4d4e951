#include "Harmonic/Private/BoxInSolid.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shape
{

namespace
{

/// At most 3 corners and one for each of 6 planes.
struct ClippedTriangle
{
  Eigen::Vector3d Corners[9];
  int Count = 0;
};

/// Keeps the part of a convex polygon where sign * (x_axis - bound) <= 0. New corners lie on the
/// plane exactly.
void ClipByPlane(ClippedTriangle& polygon, int axis, double bound, double sign)
{
  ClippedTriangle kept;
  for (int i = 0; i < polygon.Count; ++i)
  {
    const Eigen::Vector3d& a = polygon.Corners[i];
    const Eigen::Vector3d& b = polygon.Corners[(i + 1) % polygon.Count];
    const double heightA = sign * (a(axis) - bound), heightB = sign * (b(axis) - bound);
    if (heightA <= 0.0)
    {
      kept.Corners[kept.Count++] = a;
    }
    if ((heightA < 0.0 && heightB > 0.0) || (heightA > 0.0 && heightB < 0.0))
    {
      Eigen::Vector3d& cut = kept.Corners[kept.Count++];
      cut = a + heightA / (heightA - heightB) * (b - a);
      cut(axis) = bound;
    }
  }
  polygon = kept;
}

/// Returns the part of a triangle in a cube; empty if there is none.
ClippedTriangle ClipTriangle(
  const Mesh& mesh, int triangle, const Eigen::Vector3d& centre, double half)
{
  const Eigen::Matrix3d corners = GetCorners(mesh, triangle).transpose();
  ClippedTriangle polygon;
  const Eigen::Vector3d low = corners.rowwise().minCoeff(), high = corners.rowwise().maxCoeff();
  if ((low.array() > centre.array() + half).any() || (high.array() < centre.array() - half).any())
  {
    return polygon;
  }
  polygon.Count = 3;
  for (int k = 0; k < 3; ++k)
  {
    polygon.Corners[k] = corners.col(k);
  }
  // The order matters: ComputeVolumeInCube looks for corners that later planes have kept on z = top
  // and y = top.
  for (int axis = 2; axis >= 0; --axis)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      ClipByPlane(polygon, axis, centre(axis) + sign * half, sign);
    }
  }
  return polygon;
}

} // namespace

std::vector<int> FindTrianglesInCube(const Mesh& mesh, const std::vector<int>& triangles,
  const BoxCube& cube, Eigen::AlignedBox3d* bounds)
{
  std::vector<int> found;
  const double half = cube.Half * (1.0 + 2e-9);
  for (const int triangle : triangles)
  {
    const ClippedTriangle polygon = ClipTriangle(mesh, triangle, cube.Centre, half);
    if (polygon.Count == 0)
    {
      continue;
    }
    found.push_back(triangle);
    for (int i = 0; i < polygon.Count && bounds; ++i)
    {
      bounds->extend(polygon.Corners[i]);
    }
  }
  return found;
}

Eigen::AlignedBox3d BoundSolidInCube(const BoxCube& cube, const Eigen::AlignedBox3d& bounds,
  const std::function<bool(const Eigen::Vector3d&)>& isInside)
{
  // Where the solid reaches farthest along an axis, there is a point of a triangle or a face of the
  // cube. A face that no triangle meets is inside as a whole or outside, so one corner decides.
  const double margin = 1e-9 * cube.Half;
  Eigen::AlignedBox3d solid = bounds;
  for (const double sign : { -1.0, 1.0 })
  {
    const Eigen::Vector3d corner = cube.Centre.array() + sign * cube.Half;
    const Eigen::Vector3d reached = sign < 0.0 ? bounds.min() : bounds.max();
    const Eigen::Array3d gaps = sign * (corner - reached).array();
    if ((gaps <= margin).all() || !isInside(corner))
    {
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      if (gaps(axis) > margin)
      {
        Eigen::Vector3d opposite = cube.Centre.array() - sign * cube.Half;
        opposite(axis) = corner(axis);
        solid.extend(corner).extend(opposite);
      }
    }
  }
  const Eigen::AlignedBox3d whole(cube.Centre.array() - cube.Half, cube.Centre.array() + cube.Half);
  return whole.intersection({ solid.min().array() - margin, solid.max().array() + margin });
}

double ComputeVolumeInCube(
  const Mesh& mesh, const std::vector<int>& triangles, const BoxCube& cube, bool cornerInside)
{
  const Eigen::Vector3d low = cube.Centre.array() - cube.Half;
  const Eigen::Vector3d top = cube.Centre.array() + cube.Half;
  const double edge = 2.0 * cube.Half;
  // The length inside the solid of the edge y = top, z = top; the area inside of the face z = top;
  // the volume: each is the sum over the boundary of the coordinate above `low` times the normal's.
  double length = cornerInside ? edge : 0.0, area = 0.0, volume = 0.0;
  for (const int triangle : triangles)
  {
    const ClippedTriangle polygon = ClipTriangle(mesh, triangle, cube.Centre, cube.Half);
    const Eigen::Matrix3d corners = GetCorners(mesh, triangle);
    const Eigen::RowVector3d normal =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0));
    for (int i = 1; i + 1 < polygon.Count; ++i)
    {
      const Eigen::Vector3d &a = polygon.Corners[0], &b = polygon.Corners[i],
                            &c = polygon.Corners[i + 1];
      volume += 0.5 * ((b - a).cross(c - a))(2) * ((a(2) + b(2) + c(2)) / 3.0 - low(2));
    }
    for (int i = 0; i < polygon.Count; ++i)
    {
      const Eigen::Vector3d &a = polygon.Corners[i], &b = polygon.Corners[(i + 1) % polygon.Count];
      if (a(2) != top(2))
      {
        continue;
      }
      if (b(2) == top(2))
      {
        area +=
          (normal(1) > 0.0 ? 1.0 : -1.0) * std::abs(b(0) - a(0)) * (0.5 * (a(1) + b(1)) - low(1));
      }
      if (a(1) == top(1))
      {
        length += (normal(0) > 0.0 ? 1.0 : -1.0) * (a(0) - low(0));
      }
    }
  }
  area += edge * length;
  volume += edge * area;
  return std::clamp(volume, 0.0, edge * edge * edge);
}

} // namespace shape
