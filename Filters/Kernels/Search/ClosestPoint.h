#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <memory>

namespace shape
{

/// The points on a surface closest to n points. On an edge the barycentric coordinate of the
/// opposite corner is exactly 0.
struct ClosestPoints : SurfacePoints
{
  Eigen::MatrixXd Positions; ///< n x 3
  Eigen::VectorXd Distances; ///< n: >= 0
};

/// The point on a surface closest to one point.
struct ClosestPoint : SurfacePoint
{
  Eigen::RowVector3d Position;
  double Distance = 0.0;
};

/// Returns the barycentric coordinates of the point of a triangle (one corner per row) closest to
/// `position`. On an edge the coordinate of the opposite corner is exactly 0. The triangle may be
/// degenerate.
Eigen::RowVector3d FindClosestPointInTriangle(
  const Eigen::Matrix3d& corners, const Eigen::RowVector3d& position);

/// Finds the closest points on a triangulated surface, from any thread. The search tree is cached
/// in the surface, so another locator of the same surface costs nothing.
class SurfaceLocator
{
public:
  /// Throws InvalidInput if the surface has no triangle.
  explicit SurfaceLocator(const Surface& surface);

  /// points: n x 3, finite. Throws InvalidInput if the square of a distance overflows; Aborted.
  ClosestPoints Find(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// The same for one point. guess: a triangle that is likely to be close, which speeds up the
  /// search, or -1. It is returned if no other is closer, and immediately if the point lies on it
  /// up to rounding. Throws InvalidInput as above.
  ClosestPoint FindOne(const Eigen::RowVector3d& point, int guess = -1) const;

  const Surface& GetSurface() const { return this->Searched; } ///< the surface that is searched

private:
  struct Tree;
  Surface Searched;
  std::shared_ptr<const Tree> Impl;
};

} // namespace shape
