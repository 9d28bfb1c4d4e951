#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/QuadSurface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Gives each corner of a surface one point of a nearby closed quad mesh, so that the corner's
 * patches meet around the point in the same order. Assigning each quad to its closest patch rarely
 * achieves this at a corner of four or more patches. It usually gives two points of three patches
 * each, joined by a short chain of edges. The two patches on either side of this chain have no
 * curve in common.
 *
 * First a point with as many edges as the corner has patches is chosen near the corner. A disk of
 * quads around it is grown until the disk's boundary loop passes through the corner's patches in
 * their order. Wherever the patch changes along the loop, a chain of edges leads to the chosen
 * point. The chains share no other point. A minimum-cost flow makes them as short and as close to
 * the curves as possible. The quads between two consecutive chains get the patch that the loop has
 * there. A corner without such a disk is left unchanged.
 *
 * points: n x 3. patchOf: the patch of each quad.
 */
void MatchCornerValences(const Eigen::MatrixXd& points, const QuadSurface& quads,
  const Mesh& surface, const SurfaceFeatures& features, Eigen::VectorXi& patchOf);

} // namespace shape
