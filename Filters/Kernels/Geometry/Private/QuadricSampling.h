#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

namespace shape
{

/**
 * Returns the points that remain of a surface after quadric simplification (Li et al. 2010, section
 * 4.1.1; Garland and Heckbert, "Surface simplification using quadric error metrics", 1997). First,
 * all edges are halved until the surface has at least 4 `count` points.
 *
 * Of a closed surface, `count` points remain up to rounding, or more if no further edge can
 * collapse. They lie near the surface. count: >= 4. Can be aborted before and after the one call of
 * vtkQuadricDecimation. Throws Aborted.
 */
Eigen::MatrixXd SimplifyByQuadrics(const Mesh& surface, int count, const Progress& progress);

} // namespace shape
