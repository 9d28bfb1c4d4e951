#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Parameterize/InjectiveRefinement.h"

#include <string>

namespace shape
{

struct FreeBoundaryMapOptions
{
  /// Whether the conformal map, or Tutte's map if that one flips a triangle, is refined.
  bool Refine = false;
  InjectiveRefinementOptions Refinement;
};

struct FreeBoundaryMapResult
{
  Eigen::MatrixXd Points;  ///< n x 3, z = 0
  bool IsConformal = true; ///< whether the result is the conformal map, or was refined from it
  int Iterations = 0;      ///< number of refinement iterations
  double LoopLength = 0.0; ///< length of the longest boundary loop, in the surface's units
};

/**
 * Maps a surface with boundary loops and no handle to the plane z = 0 with a free boundary, without
 * flipping a triangle. The map is FlattenConformally, followed by RefineInjectively if Refine is
 * set. If the conformal map flips a triangle, refinement starts from Tutte's map of the longest
 * loop to a circle (uniform weights, other loops filled with fans). Distant parts of the image may
 * overlap.
 *
 * The conformal image has the surface's area; a refined image has the size with minimum distortion.
 * Its centroid is at the origin and x is its longer principal axis; if both have equal moments, x
 * points to the first point off the centre. The third moment along x is positive; if it vanishes,
 * the first point off the centre has positive x. So a rigid motion of the surface does not change
 * the image. Triangles are counter-clockwise seen from +z.
 *
 * Throws InvalidInput as RequireSurfaceWithBoundary. Throws SolveFailure with the number of
 * triangles if the conformal map, or Tutte's, is not counter-clockwise everywhere; Aborted.
 */
FreeBoundaryMapResult MapWithFreeBoundary(const Surface& surface,
  const FreeBoundaryMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
