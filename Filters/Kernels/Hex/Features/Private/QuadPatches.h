#pragma once

#include "Mesh/QuadSurface.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The patch of a surface for each quad (q) of a closed quad mesh near it: the closest
 * one to its centroid in the largest connected piece of each patch; the other quads are reached
 * from these, closest first. Then quads that stick out into another patch with three edges join it,
 * corners are gathered (MatchCornerValences) and pinches opened (SplitPinches). Empty where a patch
 * has no quad, or a component of the quads no patch.
 */
Eigen::VectorXi AssignQuadsToPatches(const Eigen::MatrixXd& points, const QuadSurface& quads,
  const Surface& surface, const SurfaceFeatures& features, const std::vector<Surface>& patches);

} // namespace shape
