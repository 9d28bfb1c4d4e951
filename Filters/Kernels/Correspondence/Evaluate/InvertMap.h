#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

namespace shape
{

/**
 * The inverse of a map between surfaces. It takes a position on `target` to the position on
 * `surface` whose image is nearest to it. If that is on an opposite sheet, such as an arm that
 * touches the body, distances are those of positions and, weighted by a 20th of the root of the
 * area, of normals. Images inside a triangle of `surface` are interpolated from those of its
 * corners, so the inverse is exact where the map is one to one and the target is flat, or its
 * points are images.
 */
class MapInverse
{
public:
  /// images: of the points of `surface`, on triangles of `target`. Throws InvalidInput if a surface
  /// has no triangle.
  MapInverse(const Surface& surface, const SurfacePoints& images, const Surface& target);

  /// Returns the positions on the surface whose images are these positions on the target. Throws
  /// Aborted.
  SurfacePoints Find(const SurfacePoints& positions, const Progress& progress = {}) const;

  /// The same for all points of the target.
  SurfacePoints FindAll(const Progress& progress = {}) const;

private:
  SurfacePoints FindRows(const Eigen::MatrixXd& rows, const Progress& progress) const;

  Surface Target, Moved;           ///< Moved: the surface with its points at their images
  Eigen::MatrixXd Rows, MovedRows; ///< n x 6: positions and scaled normals of both
};

/// Returns the inverse at each point of `target`: MapInverse::FindAll.
SurfacePoints InvertMap(const Surface& surface, const SurfacePoints& images, const Surface& target,
  const Progress& progress = {});

} // namespace shape
