#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// A point on a surface: a triangle, and barycentric coordinates >= 0 in it whose sum is 1. Those
/// opposite an edge that it lies on are exactly 0; at a vertex one of them is exactly 1.
struct SurfacePoint
{
  int Triangle = -1;
  Eigen::RowVector3d Barycentric = Eigen::RowVector3d::Zero();
};

/// Where on the triangles of another surface each of n places goes.
struct SurfacePoints
{
  Eigen::VectorXi Triangles;    ///< n
  Eigen::MatrixXd Barycentrics; ///< n x 3: >= 0, the sum of each row is 1
};

/// P values (n x d): where a map goes, of values (k x d) at the points of the other surface, whose
/// triangles are given, linear in each of them.
Eigen::MatrixXd PullBack(
  const SurfacePoints& map, const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values);

/// P' values (points x d): the transpose of that, of values (n x d) at the places that are mapped.
Eigen::MatrixXd PushForward(const SurfacePoints& map, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& values, Eigen::Index points);

/// The map that takes place i to point targets(i) of the other surface: to a corner of one of the
/// triangles there. Throws InvalidInput where a target has no triangle.
SurfacePoints MakeSurfacePointsAtVertices(const Eigen::VectorXi& targets, const Mesh& other);

/// The point of each triangle's corners that has most weight (n): the nearest one, but for shapes
/// of triangles.
Eigen::VectorXi FindNearestCorners(const SurfacePoints& map, const Eigen::MatrixXi& triangles);

} // namespace shape
