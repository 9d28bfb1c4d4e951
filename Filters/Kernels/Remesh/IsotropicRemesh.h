#pragma once

#include "Base/Progress.h"
#include "Geometry/FeatureAngle.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

namespace shape
{

struct IsotropicRemeshOptions
{
  double EdgeLength = 0.0; ///< the target length of edges, in the surface's units; > 0
  /// An edge is a crease if the normals of its triangles differ by more than this angle; in
  /// degrees.
  double CreaseAngle = DefaultFeatureAngle;
  int Rounds = 6; ///< number of rounds; >= 1
};

/**
 * Remeshes a closed surface with nearly equilateral triangles of uniform size (Botsch and Kobbelt,
 * "A remeshing approach to multiresolution modeling", 2004). In each round, edges that are too long
 * are split, and edges that are too short are collapsed. Then edges are flipped to bring the
 * valences closer to 6, and points slide along the surface.
 *
 * The topology is preserved. Creases are preserved, and so are points where creases meet or end.
 * Creases shorter than a few edges count as noise and are not preserved. The result is not checked
 * for self-intersections (FindSelfIntersections does so).
 *
 * surface: closed and consistently oriented. Throws InvalidInput if an option is out of range;
 * Aborted.
 */
Mesh RemeshIsotropically(
  const Surface& surface, const IsotropicRemeshOptions& options, const Progress& progress = {});

} // namespace shape
