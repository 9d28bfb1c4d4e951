#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <memory>
#include <vector>

namespace shape
{

/// For each of n given points, the closest point on a surface.
struct ClosestPoints : SurfacePoints
{
  Eigen::MatrixXd Positions; ///< n x 3
  Eigen::VectorXd Distances; ///< n values, each >= 0
};

/// The point on a surface closest to one point.
struct ClosestPoint : SurfacePoint
{
  Eigen::RowVector3d Position;
  double Distance = 0.0;
};

/// Returns the barycentric coordinates of the point of a triangle that is closest to `position`. If
/// this point lies on an edge, the coordinate of the opposite corner is exactly 0. corners: one per
/// row; the triangle may be degenerate. A corner is preferred to other points at the same distance.
Eigen::RowVector3d FindClosestPointInTriangle(
  const Eigen::Matrix3d& corners, const Eigen::RowVector3d& position);

/// Finds the closest points on a triangulated surface. Of triangles at equal distance, one whose
/// closest point is a corner is preferred: a vertex is found as a vertex. Can be used from several
/// threads. The search tree is cached in the surface, so another locator of the same surface costs
/// nothing.
class SurfaceLocator
{
public:
  /// Throws InvalidInput if the surface has no triangle.
  explicit SurfaceLocator(const Surface& surface);

  /// points: n x 3, finite. enough: if the surface is nearer to a point than this, any position
  /// that is nearer may be returned, which takes less time; >= 0. Throws InvalidInput if the square
  /// of a distance overflows; Aborted.
  ClosestPoints Find(
    const Eigen::MatrixXd& points, const Progress& progress = {}, double enough = 0.0) const;

  /// Returns the largest of the points' distances to the surface: the directed Hausdorff distance
  /// from the points. The search for a point ends as soon as it is nearer than the farthest one so
  /// far (Taha and Hanbury, "An Efficient Algorithm for Calculating the Exact Hausdorff Distance",
  /// 2015), so this takes a fraction of the time of Find, in particular if consecutive points are
  /// close to each other. Throws like Find.
  double FindLargestDistance(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// The same for one point. guess: a triangle that is likely to be close, or -1. A good guess
  /// speeds up the search. At equal distance it is preferred, except to a corner. If the point
  /// lies on it up to rounding, there is no search. Throws InvalidInput if the square of a distance
  /// overflows.
  ClosestPoint FindOne(const Eigen::RowVector3d& point, int guess = -1) const;

  const Surface& GetSurface() const { return this->Searched; } ///< the surface that is searched

private:
  struct Tree;
  class Sequence;
  Surface Searched;
  std::shared_ptr<const Tree> Impl;
};

/// Returns the edges of polylines (k x 3 each, in order) as triangles without area, whose locator
/// finds the closest points of the polylines.
Mesh BuildFlatTriangles(const std::vector<Eigen::MatrixXd>& polylines);

} // namespace shape
