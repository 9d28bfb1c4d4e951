#pragma once

#include "Geometry/SignedDistance.h"

namespace shape
{

struct OffsetSurfaceOptions
{
  /// Grid cells along the offset distance: more gives a finer surface.
  double CellsPerDistance = 3.0;
  /// Most samples the grid may have. The cells grow up to the offset distance to stay below.
  double MaximumSamples = 2e7;
};

/**
 * The points at signed distance `distance` outside a closed surface, as a surface that faces
 * outwards: pieces inside the surface's hollows included where they are open to the outside or wide
 * enough.
 *
 * The signed distance is sampled on a grid, only near the level wanted: a distance changes by no
 * more than one takes steps, so a block of cells whose centre is farther from the level than from
 * its own corners is skipped. The points are then moved to their exact distance.
 *
 * distance: > 0, in the surface's units. Throws InvalidInput where it is not, or where the grid
 * would need more samples than allowed; Aborted.
 */
Mesh OffsetSurface(const SignedDistance& field, double distance,
  const OffsetSurfaceOptions& options = {}, const Progress& progress = {});

/// Moves points near a surface to `distance` from it, outwards, away from their closest points.
void MoveToDistance(Eigen::MatrixXd& points, const SignedDistance& field, double distance,
  const Progress& progress = {});

} // namespace shape
