#pragma once

#include "Distance/SignedDistance.h"

namespace shape
{

struct OffsetSurfaceOptions
{
  /// Number of grid cells along the offset distance; a larger number gives a finer surface.
  double CellsPerDistance = 2.0;
  /// Maximum number of samples of the grid. If necessary, the cells are enlarged, at most to the
  /// offset distance.
  double MaximumSamples = 2e7;
};

/**
 * Returns the outward-facing surface formed by the points that lie outside a closed surface at the
 * distance `distance`. It enters hollows of the surface if they are wide enough.
 *
 * The signed distance is sampled on a grid, only where it is close to `distance`. Blocks of the
 * grid are divided into eight recursively. A block is skipped if the signed distance at its centre
 * differs from `distance` by more than half the block's diagonal: a distance function is
 * 1-Lipschitz. Interpolation between the samples changes the distance by up to a tenth;
 * MoveToDistance corrects this.
 *
 * distance: > 0, in the surface's units. The result is empty if the surface faces inwards and
 * encloses no point at that distance. Throws InvalidInput if the distance is not > 0, or if the
 * grid would need more samples than allowed; Aborted.
 */
Mesh BuildOffsetSurface(const SignedDistance& field, double distance,
  const OffsetSurfaceOptions& options = {}, const Progress& progress = {});

/// Moves points (n x 3) near a surface to the given distances (n) from it, along the lines from
/// their closest points. If another part of the surface is nearer to the moved point, its final
/// distance is smaller.
void MoveToDistance(Eigen::MatrixXd& points, const SignedDistance& field,
  const Eigen::VectorXd& distances, const Progress& progress = {});

} // namespace shape
