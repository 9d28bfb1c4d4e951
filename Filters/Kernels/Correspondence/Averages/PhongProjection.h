#pragma once

#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"
#include "Search/TriangleTree.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Phong projection onto a surface in d dimensions (Panozzo and others 2013, section 4). Each point
 * of the surface has a tangent plane, which varies continuously. A position x is projected to the
 * point p for which x - p is perpendicular to the tangent plane at p. Unlike the closest point, p
 * is a smooth function of x across edges and vertices.
 *
 * At a vertex, the tangent plane is the mean of its triangles' planes by area: the span of the two
 * leading eigenvectors of the mean projection. Inside a triangle, it is that of the mean of the
 * projections at the corners, with barycentric coordinates as weights. On an edge, it depends only
 * on the edge's ends, so it is continuous.
 */
class PhongProjection
{
public:
  static constexpr int MaximumDimension = 64;
  using Plane = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, MaximumDimension, 2>;

  /// surface: an oriented 2-manifold with a triangle at each point. positions: n x d, with d from 2
  /// to MaximumDimension.
  PhongProjection(const Surface& surface, const Eigen::MatrixXd& positions);

  /// Returns an orthonormal basis (d x 2) of the tangent plane at a vertex.
  const Plane& TangentAt(int vertex) const { return this->Tangents[vertex]; }

  /// Returns the projection of a position (d values), found by a walk from `start`. If the walk
  /// goes in a circle, or leaves the surface across a boundary, it is the point of the surface
  /// nearest to the position.
  SurfacePoint Find(const Eigen::RowVectorXd& position, const SurfacePoint& start) const;

private:
  Plane TangentIn(int triangle, const Eigen::RowVector3d& barycentric) const;
  Eigen::RowVector3d Solve(
    int triangle, const Eigen::RowVectorXd& position, Eigen::RowVector3d barycentric) const;

  const Surface Searched;
  const Eigen::MatrixXd Positions;
  TriangleTree Tree;
  std::vector<Plane> Tangents;
};

} // namespace shape
