#pragma once

#include "Mesh/HexMesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Returns the patch of each face (HexFaces) of each hexahedron (m x 6); -1 for faces that are not
/// among the quads. quads: q x 4 points of the solid. patches: the patch of each quad.
Eigen::MatrixXi FindFacePatches(
  const HexMesh& solid, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patches);

/// Returns for each quad the patch given for the triangle nearest to its centre. points, quads:
/// q x 4, near the surface. given: a patch for each triangle of the surface.
Eigen::VectorXi FindNearestPatches(const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads,
  const Surface& surface, const Eigen::VectorXi& given);

/// Returns for each quad the value of most quads of the same patch. At a concave crease, the
/// triangle nearest to a quad can belong to the patch beside it. patches: the patch of each quad.
Eigen::VectorXi TakeMostFrequent(const Eigen::VectorXi& values, const Eigen::VectorXi& patches);

} // namespace shape
