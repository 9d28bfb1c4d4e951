#pragma once

#include "Base/Progress.h"
#include "Geometry/FeatureAngle.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

namespace shape
{

struct IsotropicRemeshOptions
{
  double EdgeLength = 0.0; ///< wanted, in the surface's units; > 0
  /// Degrees between the normals at a crease; creases are kept.
  double CreaseAngle = DefaultFeatureAngle;
  int Rounds = 6; ///< >= 1
};

/**
 * A surface of nearly equilateral triangles of one size near a closed surface: edges that are too
 * long are split, those too short are collapsed, flips make the valences even, and points slide
 * along the surface (Botsch and Kobbelt, "A remeshing approach to multiresolution modeling", 2004).
 *
 * Creases stay where they are, and so do points where they meet or end. Creases shorter than some
 * edges are noise and are not kept. The topology stays; whether the result intersects itself is not
 * checked (FindSelfIntersections).
 *
 * surface: closed, consistently oriented. Throws InvalidInput if options are out of range,
 * Aborted.
 */
Mesh RemeshIsotropically(
  const Surface& surface, const IsotropicRemeshOptions& options, const Progress& progress = {});

} // namespace shape
