#pragma once

#include "Mesh/QuadSurface.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Assigns each quad of a nearby closed quad mesh to one of the surface's patches. Each quad first
 * gets the patch closest to its centroid. Only the largest connected piece of each patch is kept.
 * The pieces then grow over the other quads. Each step adds the adjacent quad that is closest to
 * the patch of its piece. A quad joins another patch if three of its edges border this patch.
 * Finally corners are matched (MatchCornerValences) and pinches are removed (SplitPinches).
 *
 * Returns the patch of each quad. A patch may get no quad. The result is empty if a component of
 * the quads gets no patch.
 */
Eigen::VectorXi AssignQuadsToPatches(const Eigen::MatrixXd& points, const QuadSurface& quads,
  const Surface& surface, const SurfaceFeatures& features, const std::vector<Surface>& patches);

} // namespace shape
