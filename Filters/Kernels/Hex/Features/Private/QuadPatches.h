#pragma once

#include "Mesh/QuadSurface.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Assigns one of a surface's patches to each quad (q) of a nearby closed quad mesh. Each quad first
 * gets the patch closest to its centroid, and the largest connected piece of each patch keeps it.
 * The other quads are reached from these pieces, closest first. Then quads of which three edges
 * border another patch join it, corners are matched (MatchCornerValences) and pinches removed
 * (SplitPinches). Empty if a patch gets no quad, or if a component of the quads gets no patch.
 */
Eigen::VectorXi AssignQuadsToPatches(const Eigen::MatrixXd& points, const QuadSurface& quads,
  const Surface& surface, const SurfaceFeatures& features, const std::vector<Surface>& patches);

} // namespace shape
