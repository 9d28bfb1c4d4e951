#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// A point on a surface: a triangle, and barycentric coordinates >= 0 whose sum is 1. On an edge
/// the coordinate of the opposite corner is exactly 0; at a vertex one coordinate is exactly 1.
struct SurfacePoint
{
  int Triangle = -1;
  Eigen::RowVector3d Barycentric = Eigen::RowVector3d::Zero();
};

/// The images of n points on the triangles of another surface.
struct SurfacePoints
{
  Eigen::VectorXi Triangles;    ///< n
  Eigen::MatrixXd Barycentrics; ///< n x 3: >= 0, the sum of each row is 1
};

/// Returns P values (n x d): values at the points of the other surface (k x d), interpolated
/// linearly at the images. triangles: those of the other surface.
Eigen::MatrixXd PullBack(
  const SurfacePoints& map, const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values);

/// Returns P^T values (points x d): the transpose of PullBack, applied to values (n x d) at the
/// points that are mapped.
Eigen::MatrixXd PushForward(const SurfacePoints& map, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& values, Eigen::Index points);

/// Returns the map that takes point i to vertex targets(i) of the other surface, as a corner of one
/// of its triangles. Throws InvalidInput if a target belongs to no triangle.
SurfacePoints MakeSurfacePointsAtVertices(const Eigen::VectorXi& targets, const Mesh& other);

/// Returns, for each image, the corner of its triangle with the largest barycentric coordinate (n);
/// in well-shaped triangles this is the nearest corner.
Eigen::VectorXi FindNearestCorners(const SurfacePoints& map, const Eigen::MatrixXi& triangles);

} // namespace shape
