#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A surface given by points that sample it, with the triangles between neighbouring points.
struct SampledSurface
{
  /// The given points (n x 3), and m local triangles, counter-clockwise seen along the normals.
  /// They overlap where the points around do not agree on one triangulation. Of coincident points,
  /// only the first has triangles.
  Mesh Surface;
  Eigen::MatrixXd Normals; ///< n x 3: unit normals, the given or the estimated ones
  /// m values: the share of its corners around which the triangle is a local one. The sum of the
  /// triangles' areas times their shares is the area of the surface.
  Eigen::VectorXd Shares;
  /// n values: whether the local triangles do not surround the point. It is on a boundary, or at a
  /// gap of the sampling.
  std::vector<char> OnRim;
};

struct SampledSurfaceOptions
{
  /// Number of nearest points that make up the neighbourhood of a point. Its radius is the largest
  /// radius of a circumscribed circle: with more points, triangles bridge wider gaps.
  int Nearest = 24;
};

/**
 * Connects points that sample a surface, without reconstructing it: each point is connected by the
 * Delaunay triangles around it in its tangent plane (Sharp and Crane, "A Laplacian for nonmanifold
 * triangle meshes", 2020, section 5.7). The nearest points are projected to this plane and keep
 * their distances. Points with an opposite normal are on another sheet and are left out, as are
 * triangles whose circumscribed circle is larger than the neighbourhood. In a plane, the triangles
 * are the Delaunay triangulation of the points, except for large triangles at its boundary.
 *
 * The triangles of a point are found by inversion: circles through the point become lines, so its
 * Delaunay triangles are the edges of the convex hull of the inverted points. Positions are moved
 * by 1e-6 of the distance to the nearest point for this only, so that points on a circle have one
 * triangulation.
 *
 * points: n x 3. normals: n x 3, pointing to one side of the surface, of any length > 0; or an
 * empty matrix, to estimate them (EstimatePointNormals).
 *
 * Throws InvalidInput if there is no local triangle, because there are fewer than 3 distinct points
 * or they lie on a line; if a value is not finite, or a normal is zero; if Nearest is less than 6;
 * Aborted.
 */
SampledSurface ConnectSamples(const Eigen::MatrixXd& points, const Eigen::MatrixXd& normals = {},
  const SampledSurfaceOptions& options = {}, const Progress& progress = {});

/// Returns the mean length of an edge of the local triangles: the distance of neighbouring points.
double ComputeSpacing(const SampledSurface& samples);

} // namespace shape
