#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Polygons whose corners on both sides of a seam are different points.
struct SplitPolygons
{
  std::vector<std::vector<int>> Polygons; ///< the given ones, with new points at seams
  std::vector<int> Copied;                ///< for each new point, the point that it copies
  Eigen::MatrixXd Texture;                ///< (r + new points) x 2
};

/// Returns whether the texture of a surface has a seam: two points of its boundary at the same
/// position.
bool HasSeams(const Surface& surface);

/**
 * Splits polygons along the seams of a texture that was transferred to their points.
 *
 * At a seam, a textured surface has two points at the same position, with different texture
 * coordinates. A polygon of the receiver whose corners lie on both sides must not interpolate
 * between them. It belongs to the side on which the position of its centroid lies. The texture
 * coordinates of its corners are those at the end of a walk (TriangleWalk) from there towards the
 * position of the corner, which stops at the seam. Corners with other coordinates than the point
 * has become new points. So in each polygon the texture is as continuous as on the giver, and it
 * covers no more than the giver's triangles do. The seam follows the polygons' edges.
 *
 * giver: a 2-manifold, open or closed. texture: n x 2, at the giver's points. polygons: the corners
 * of each, indices of the r points. positions: r x 3, of the receiver's points on the giver; found:
 * r x 2, the coordinates that were transferred to them. Throws InvalidInput if the giver has no
 * triangle; Aborted.
 */
SplitPolygons SplitAtSeams(const Surface& giver, const Eigen::MatrixXd& texture,
  const std::vector<std::vector<int>>& polygons, const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& found, const Progress& progress = {});

} // namespace shape
