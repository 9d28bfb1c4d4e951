#pragma once

#include "Distance/SignedDistance.h"

namespace shape
{

struct OffsetSurfaceOptions
{
  /// Number of grid cells along the offset distance; a larger number gives a finer surface.
  double CellsPerDistance = 2.0;
  /// Maximum number of samples of the grid. The cells grow, up to the offset distance, to meet it.
  double MaximumSamples = 2e7;
};

/**
 * Returns the points at signed distance `distance` outside a closed surface, as a surface that
 * faces outwards. It enters hollows of the surface if they are wide enough.
 *
 * The signed distance is sampled on a grid, only near the wanted level. A distance function is
 * 1-Lipschitz, so a block is skipped if its centre is farther from the level than from the block's
 * corners. Otherwise it is divided in eight. Interpolation between the samples changes the distance
 * by up to a tenth; MoveToDistance corrects that.
 *
 * distance: > 0, in the surface's units. The result is empty if the surface faces inwards and
 * encloses no point at that distance. Throws InvalidInput if the distance is not > 0, or if the
 * grid would need more samples than allowed; Aborted.
 */
Mesh BuildOffsetSurface(const SignedDistance& field, double distance,
  const OffsetSurfaceOptions& options = {}, const Progress& progress = {});

/// Moves points (n x 3) near a surface to the given distances (n) from it, away from their closest
/// points. Where another part of the surface is nearer than that, the final distance may differ.
void MoveToDistance(Eigen::MatrixXd& points, const SignedDistance& field,
  const Eigen::VectorXd& distances, const Progress& progress = {});

} // namespace shape
