#pragma once

#include "Distance/SignedDistance.h"

namespace shape
{

struct OffsetSurfaceOptions
{
  /// Grid cells along the offset distance: more gives a finer surface.
  double CellsPerDistance = 2.0;
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
 * its own corners is skipped; else it is halved, and its parts are asked. Interpolation between the
 * samples takes the surface off its distance by up to a tenth; MoveToDistance mends that.
 *
 * distance: > 0, in the surface's units. Empty where the surface faces inwards and encloses no
 * point at that distance. Throws InvalidInput where it is not, or where the grid
 * would need more samples than allowed; Aborted.
 */
Mesh BuildOffsetSurface(const SignedDistance& field, double distance,
  const OffsetSurfaceOptions& options = {}, const Progress& progress = {});

/// Moves points (n x 3) near a surface outwards to the given distances (n) from it, away from their
/// closest points. Where another part of the surface is nearer than that, they may end elsewhere.
void MoveToDistance(Eigen::MatrixXd& points, const SignedDistance& field,
  const Eigen::VectorXd& distances, const Progress& progress = {});

} // namespace shape
