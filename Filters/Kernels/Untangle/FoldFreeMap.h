#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Untangle/Untangle.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Untangles a solid that a map has moved, and enforces the map's boundary values. A boundary point
 * of the solid counts as lying on the map's boundary surface if their distance is at most 1e-6
 * times the longest edge of the surface's bounding box. Such a point is put exactly on the
 * surface's image. The other boundary points keep their images. The interior is then untangled with
 * a fixed boundary (Untangle). The result is a mesh, not a map that could be evaluated elsewhere.
 *
 * domain: the solid's cells before the map. moved (n x 3): the images of the solid's points.
 * boundary: the map's boundary surface, in the space of the domain. targets: the images of the
 * points of `boundary`. In the result, InvertedBefore counts the cells that the map inverts. Throws
 * whatever Untangle throws.
 */
UntangleResult ComputeFoldFreeMap(const Cells& domain, const Eigen::MatrixXd& moved,
  const Mesh& boundary, const Eigen::MatrixXd& targets, const Progress& progress = {});

} // namespace shape
