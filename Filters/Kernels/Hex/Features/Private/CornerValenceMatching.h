#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/QuadSurface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Gives each corner of a surface one point of a nearby closed quad mesh, around which the corner's
 * patches meet in the same order. Labels by distance rarely do so at a corner of four or more
 * patches. They usually give two points of three patches each, joined by a short chain of edges
 * between two patches that have no curve in common.
 *
 * First a point near the corner is chosen that has as many edges as the corner has patches. A disk
 * of quads around it is grown until its boundary loop has the corner's patches in their order. From
 * each change of patch on the loop a chain of edges leads to the point. The chains share no other
 * point and are as short and as close to the curves as possible (a minimum-cost flow). The quads
 * between two chains get the patch of the loop there. A corner without such a disk is left
 * unchanged.
 *
 * points: n x 3. patchOf: the patch of each quad.
 */
void MatchCornerValences(const Eigen::MatrixXd& points, const QuadSurface& quads,
  const Mesh& surface, const SurfaceFeatures& features, Eigen::VectorXi& patchOf);

} // namespace shape
