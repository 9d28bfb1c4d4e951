#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Parameterize/InjectiveRefinement.h"

#include <string>

namespace shape
{

struct FreeBoundaryMapOptions
{
  /// Whether the conformal map, or Tutte's if that flips a triangle, is refined.
  bool Refine = false;
  InjectiveRefinementOptions Refinement;
};

struct FreeBoundaryMapResult
{
  Eigen::MatrixXd Points;  ///< n x 3, z = 0
  bool IsConformal = true; ///< whether the conformal map is the result, or the start
  int Iterations = 0;      ///< of the refinement
  double LoopLength = 0.0; ///< of the longest boundary loop, in the surface's units
};

/**
 * Maps a surface with boundary loops and no handle to the plane z = 0, its boundary free, with no
 * triangle flipped: FlattenConformally, or where Refine is set RefineInjectively from there; from
 * Tutte's map of the longest loop to a circle (uniform weights, other loops filled with fans) if
 * the conformal one flips a triangle. Far parts of the image may overlap.
 *
 * The conformal image has the surface's area, a refined one the size at which it is least
 * distorted. Its centroid is at the origin. x is its longer principal axis,
 * in the direction in which it reaches farther (by the third moment); if these do not tell, its
 * point of lowest number that is off the centre lies in the direction of x. So the image does not
 * change when the surface moves. Triangles run counter-clockwise seen from +z.
 *
 * Throws InvalidInput as RequireSurfaceWithBoundary, SolveFailure with the count if a triangle
 * of the conformal map, or of Tutte's, is not counter-clockwise; Aborted.
 */
FreeBoundaryMapResult MapWithFreeBoundary(const Surface& surface,
  const FreeBoundaryMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
