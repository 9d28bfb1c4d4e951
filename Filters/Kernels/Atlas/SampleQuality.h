#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Raises the minimum scaled Jacobian of hexahedra that a map has carried into a sample, if it is
 * below `wanted`. Points of the hexahedra below it, and around them, are moved (OptimizeHexahedra).
 * Boundary points slide on the sample. A boundary point stays where it is if it is on a crease,
 * where boundary quads meet at more than DefaultFeatureAngle, or farther from the sample than 1e-6
 * of its longest side. Points between two regions stay, too.
 *
 * mesh: without inverted hexahedra. regions: the region of each hexahedron, or empty. If the
 * minimum cannot be raised, no point is moved. Returns the minimum scaled Jacobian of the result.
 * Throws InvalidInput if an index is out of range; Aborted.
 */
double RaiseSampleQuality(HexMesh& mesh, const Eigen::VectorXi& regions, const Surface& sample,
  double wanted, const Progress& progress = {});

} // namespace shape
