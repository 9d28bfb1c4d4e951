#pragma once

#include "Base/Progress.h"
#include "Correspondence/CommonBase/BaseDomain.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct CommonBaseMap
{
  SurfaceMaps Maps;
  int Patches = 0; ///< of the base domain
  int Genus = 0;
  /// The symmetric Dirichlet energy of A's map divided by A's area; 4 for an isometry.
  double Energy = 0.0;
  /// The number of triangles of both surfaces that are not counter-clockwise on the flat surface
  /// through which the map goes, by exact predicates. The map is one to one if there is none.
  int Flipped = 0;
};

/**
 * Computes a one-to-one map between two closed surfaces of the same genus that takes each landmark
 * exactly to its partner and keeps orientation.
 *
 * 1. Both surfaces are divided into the same triangular patches (TraceBaseDomain), and each patch
 * is mapped to the same triangle of the plane. Equilateral triangles, glued along the sides of
 *    patches, are a flat surface with cones at the landmarks, which both surfaces cover once.
 * 2. The points of both surfaces move on the flat surface in turn, across the sides of patches, so
 *    that the symmetric Dirichlet energy of the map falls (Smith and Schaefer, "Bijective
 *    parameterization with free boundaries", 2015).
 * 3. A point goes to the point of the other surface at the same position.
 *
 * On the flat surface all positions are multiples of 2^-44. Rotations by 60 degrees are exact then,
 * in coordinates along two sides of a triangle, so that the exact predicates, which keep every
 * triangle counter-clockwise, are exact across patches, too.
 *
 * a, b, landmarks: as for TraceBaseDomain. Throws the exceptions of TraceBaseDomain. Throws
 * SolveFailure if triangles are too small for double precision, usually on a protrusion without a
 * landmark; Aborted.
 */
CommonBaseMap MapThroughBase(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress = {});

} // namespace shape
