#pragma once

#include "Core/Mesh.h"
#include "Core/Progress.h"

namespace shape
{

/**
 * Simplifies a surface by the quadric error metric (Garland and Heckbert 1997;
 * vtkQuadricDecimation) until about `points` points are left: closed surfaces of known topology to
 * within a few in a hundred. The points are placed where the metric is least, not on the surface.
 *
 * Throws InvalidInput where points < 4, Aborted. Returns the input where it has no more points.
 */
Mesh Decimate(const Mesh& mesh, int points, const Progress& progress = {});

/// Splits each triangle into four at the middles of its edges: the same surface with more points.
Mesh Subdivide(const Mesh& mesh);

} // namespace shape
