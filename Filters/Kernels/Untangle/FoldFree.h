#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"
#include "Mesh/Mesh.h"
#include "Untangle/Untangle.h"

#include <Eigen/Core>

namespace shape
{

/**
 * A solid that a map of its boundary's surface has carried, without inverted cells: points of the
 * solid's boundary that lie on the surface (to 1e-6 of its longest side) are put exactly on its
 * image, the others stay where the map took them, and what is inside is untangled, the boundary
 * fixed (Untangle). The result is a mesh, not a map that could be evaluated elsewhere.
 *
 * domain: solid cells before the map; moved (n x 3): where it took their points. boundary: a
 * surface in the domain's space; targets: the images of its points. Throws what Untangle throws.
 */
UntangleResult ComputeFoldFreeMap(const Cells& domain, const Eigen::MatrixXd& moved,
  const Mesh& boundary, const Eigen::MatrixXd& targets, const Progress& progress = {});

} // namespace shape
