#pragma once

#include "Base/Progress.h"
#include "Geometry/SampledSurface.h"

#include <vector>

namespace shape
{

/// The boundary loops of a surface given by points: each has at least 4 points, and each point
/// once.
struct CloudBoundary
{
  /// Loops around holes, with the hole to the left, the longest first.
  std::vector<std::vector<int>> Holes;
  /// Loops around the surface, such as the outer boundary of a sheet or of a bowl, with the surface
  /// to the left, the longest first.
  std::vector<std::vector<int>> Outer;
};

/**
 * Finds the holes of a surface given by points.
 *
 * A point is on the boundary if its local triangles do not surround it (SampledSurface::OnRim): a
 * circle beside it that contains no other point of the surface has a radius larger than the
 * distance of its 24th neighbour, about three spacings. As by the angle criterion of Bendels et
 * al., "Detecting holes in point set surfaces" (2006), the neighbours then leave a gap around the
 * point; but the size of the gap decides, not its angle. From there, local triangles with
 * circumscribed circles larger than the spacing are removed, so that the loop passes through all
 * points around the hole. Edges between boundary points with a triangle on one side only are
 * linked to loops. Where several leave a point, the next one around the hole is taken.
 *
 * A loop is around the surface, and not around a hole, if it is counter-clockwise seen along the
 * mean of the normals at its points, with the surface to the left. Throws Aborted.
 */
CloudBoundary FindCloudBoundary(const SampledSurface& samples, const Progress& progress = {});

} // namespace shape
