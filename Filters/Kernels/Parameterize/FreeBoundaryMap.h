#pragma once

#include "Base/Progress.h"
#include "Distortion/InjectiveRefinement.h"
#include "Mesh/Surface.h"

#include <string>

namespace shape
{

struct FreeBoundaryMapOptions
{
  /// Whether RefineInjectively lowers the distortion. It starts from the conformal map or, if that
  /// map flips a triangle, from Tutte's map.
  bool Refine = false;
  InjectiveRefinementOptions Refinement;
};

struct FreeBoundaryMapResult
{
  Eigen::MatrixXd Points;  ///< n x 3, z = 0
  bool IsConformal = true; ///< false if Tutte's map was the start of the refinement
  int Iterations = 0;      ///< number of refinement iterations
  /// mean of the refinement's measure before and after it (InjectiveRefinementResult); else 0
  double MeasureBefore = 0.0, MeasureAfter = 0.0;
  double LoopLength = 0.0; ///< length of the longest boundary loop, in the surface's units
};

/**
 * Maps a surface with boundary loops and no handle to the plane z = 0 with a free boundary, without
 * flipping a triangle. FlattenConformally computes the map; if Refine is set, RefineInjectively
 * lowers its distortion. If the conformal map flips a triangle, refinement starts from Tutte's map
 * of the longest loop to a circle (uniform weights, other loops filled with fans). Distant parts of
 * the image may overlap.
 *
 * The conformal image has the surface's area, also if it is refined by ConformalAMIPS, which no
 * size changes; an image refined by another measure has the size of minimum distortion.
 * The image's centroid is at the origin and its longer principal axis lies along x. If both axes
 * have equal moments, x points to the first point off the centre. The third moment along x is
 * positive; if it vanishes, the first point off the centre has positive x. So a rigid motion of the
 * surface does not change the image. Triangles are counter-clockwise seen from +z.
 *
 * Throws InvalidInput when RequireSurfaceWithBoundary(surface, LoopCount::AtLeastOne) does, if the
 * surface has no area, or if an option of Refinement is out of range. Throws SolveFailure when
 * FlattenConformally or RefineInjectively does. Also throws SolveFailure if the conformal map flips
 * a triangle and Refine is not set, or if triangles are too small for double precision. Throws
 * Aborted.
 */
FreeBoundaryMapResult MapWithFreeBoundary(const Surface& surface,
  const FreeBoundaryMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
