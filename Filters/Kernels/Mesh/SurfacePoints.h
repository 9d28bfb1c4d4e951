#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// A point on a surface, in barycentric coordinates of a triangle. Each coordinate is >= 0, and
/// their sum is 1. On an edge the coordinate of the opposite corner is exactly 0. At a vertex one
/// coordinate is exactly 1.
struct SurfacePoint
{
  int Triangle = -1;
  Eigen::RowVector3d Barycentric = Eigen::RowVector3d::Zero();
};

/// Returns the position of a point on a surface.
inline Eigen::RowVector3d GetPosition(const Mesh& surface, const SurfacePoint& point)
{
  return point.Barycentric * GetCorners(surface, point.Triangle);
}

/// The images of n points on the triangles of another surface.
struct SurfacePoints
{
  Eigen::VectorXi Triangles;    ///< for each of the n points, the triangle of its image
  Eigen::MatrixXd Barycentrics; ///< n x 3, each >= 0; each row sums to 1
};

/// Returns the product of P and `values` (n x d): the values interpolated linearly at the images.
/// values: k x d, at the points of the other surface. triangles: the triangles of the other
/// surface.
Eigen::MatrixXd PullBack(
  const SurfacePoints& map, const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values);

/// Returns the product of P^T and `values` (points x d), where P is the linear map of PullBack.
/// values: n x d, at the mapped points. points: the number of points of the other surface.
Eigen::MatrixXd PushForward(const SurfacePoints& map, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& values, Eigen::Index points);

/// Returns the map that takes point i to vertex targets(i) of the other surface. Throws
/// InvalidInput if a target belongs to no triangle.
SurfacePoints MakeSurfacePointsAtVertices(const Eigen::VectorXi& targets, const Mesh& other);

/// Returns, for each image, the corner of its triangle with the largest barycentric coordinate (n);
/// in well-shaped triangles this is the nearest corner.
Eigen::VectorXi FindNearestCorners(const SurfacePoints& map, const Eigen::MatrixXi& triangles);

} // namespace shape
