#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/QuadSurface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Gives each corner of a surface one point of a closed quad mesh near it, around which the corner's
 * patches meet in the corner's order. Labels by distance seldom do so where four or more patches
 * meet: two points with three of them each are more likely, with a short chain between them of two
 * patches that have no curve in common.
 *
 * Around a point near the corner with as many edges as the corner has patches, a disc of quads is
 * grown until its boundary loop has the patches of the corner in their order; from where patches
 * meet on the boundary loop as many chains of edges are led to the point, with no point in common
 * and as short and near the curves as can be (a minimum-cost flow), and the quads between two of
 * them get the boundary loop's patch. Corners for which no such disc is found stay as they are.
 *
 * points: n x 3. patchOf: of each quad.
 */
void MatchCornerValences(const Eigen::MatrixXd& points, const QuadSurface& quads,
  const Mesh& surface, const SurfaceFeatures& features, Eigen::VectorXi& patchOf);

} // namespace shape
