#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>

namespace shape
{

/// Returns the patch of each face (HexFaces) of each hexahedron (m x 6); -1 for faces that are not
/// among the quads. quads: q x 4 points of the solid. patches: the patch of each quad.
Eigen::MatrixXi FindFacePatches(
  const HexMesh& solid, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patches);

} // namespace shape
