#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <memory>

namespace shape
{

/// Where on a surface the closest points to n points lie; barycentric coordinates are exactly 0
/// opposite an edge that a place lies on.
struct ClosestPoints : SurfacePoints
{
  Eigen::MatrixXd Positions; ///< n x 3
  Eigen::VectorXd Distances; ///< n: >= 0
};

/// Where on a surface the closest point to one point lies.
struct ClosestPoint : SurfacePoint
{
  Eigen::RowVector3d Position;
  double Distance = 0.0;
};

/// Barycentric coordinates of the point of a triangle (one corner a row) closest to `place`; those
/// opposite an edge that it lies on are exactly 0. The triangle may have no area.
Eigen::RowVector3d FindClosestPointInTriangle(
  const Eigen::Matrix3d& corners, const Eigen::RowVector3d& position);

/// Finds the closest points of a triangulated surface, from any thread. The search tree is kept
/// with the surface: a second locator of the same one costs nothing.
class SurfaceLocator
{
public:
  /// Throws InvalidInput if the surface has no triangle.
  explicit SurfaceLocator(const Surface& surface);

  /// points: n x 3, finite. Throws InvalidInput where the square of a distance overflows, Aborted.
  ClosestPoints Find(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// The same for one point. guess: a triangle that is likely near, which makes it quicker and is
  /// taken where no other is nearer, and at once where the point lies on it but for rounding; or
  /// -1. Throws InvalidInput as above.
  ClosestPoint FindOne(const Eigen::RowVector3d& point, int guess = -1) const;

  const Surface& GetSurface() const { return this->Searched; } ///< the surface that is searched

private:
  struct Tree;
  Surface Searched;
  std::shared_ptr<const Tree> Impl;
};

} // namespace shape
