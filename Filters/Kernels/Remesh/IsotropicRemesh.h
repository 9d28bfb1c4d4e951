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
  /// Degrees between normals above which an edge is a crease.
  double CreaseAngle = DefaultFeatureAngle;
  int Rounds = 6; ///< number of rounds; >= 1
};

/**
 * Returns a surface of nearly equilateral triangles of uniform size close to a closed surface.
 * Edges that are too long are split, those too short are collapsed, flips equalise the valences,
 * and points slide along the surface (Botsch and Kobbelt, "A remeshing approach to multiresolution
 * modeling", 2004).
 *
 * Creases are preserved, and so are points where they meet or end. Creases shorter than a few edges
 * are treated as noise and are not preserved. The topology is preserved; self-intersections of the
 * result are not checked (FindSelfIntersections).
 *
 * surface: closed and consistently oriented. Throws InvalidInput if an option is out of range;
 * Aborted.
 */
Mesh RemeshIsotropically(
  const Surface& surface, const IsotropicRemeshOptions& options, const Progress& progress = {});

} // namespace shape
