#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>

namespace shape
{

/// Hexahedra, and where their points lie on the polycube.
struct IntegerMapHexesResult
{
  HexMesh Solid;
  Eigen::MatrixXd Positions;  ///< n x 3: integers
  Eigen::VectorXi Tetrahedra; ///< n: the tetrahedron that the point is in
  Eigen::MatrixXd Weights;    ///< n x 4: of the tetrahedron's points
  bool Overlaps = false;      ///< some cells of the grid are there several times
};

/**
 * The hexahedra that a map of tetrahedra takes to the unit cells of the integer grid: the map is
 * positive on every tetrahedron, and takes each triangle of the boundary into a plane of integer
 * coordinate. The images may overlap: what lies side by side is told by walks through the
 * tetrahedra, not by coordinates.
 *
 * points, images (n x 3), tetrahedra (m x 4). Throws SolveFailure where there is no cell, or walks
 * do not agree with one another.
 */
IntegerMapHexesResult ExtractIntegerMapHexahedra(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const Eigen::MatrixXi& tetrahedra);

} // namespace shape
