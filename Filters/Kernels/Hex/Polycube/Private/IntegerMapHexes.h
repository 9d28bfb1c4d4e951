#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * Walks along straight lines through tetrahedra, from one to the next across their faces. All of
 * them are positive, but those that are not neighbours may overlap: the walk stays on its sheet.
 */
class TetrahedralWalk
{
public:
  /// Keeps references.
  TetrahedralWalk(const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra);

  struct Position
  {
    int Tetrahedron;
    Eigen::Vector4d Weights; ///< of its corners: >= 0, their sum is 1
    bool Arrived;            ///< false: the boundary came in between, and this is where
    int Face = -1;           ///< the corner opposite the face of the boundary that it met
  };

  /// From a position in a tetrahedron to another position.
  Position Go(int tetrahedron, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  /// Barycentric coordinates.
  Eigen::Vector4d Weights(int tetrahedron, const Eigen::Vector3d& position) const;

private:
  const Eigen::MatrixXd& Points;
  const Eigen::MatrixXi& Tetrahedra;
  std::vector<std::array<int, 4>> Neighbours; ///< across the face opposite each corner, or -1
};

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
 * coordinate. The images may overlap: what lies side by side is found by walks through the
 * tetrahedra, not by coordinates.
 *
 * points, images (n x 3), tetrahedra (m x 4). Throws SolveFailure where there is no cell, or walks
 * do not agree with one another.
 */
IntegerMapHexesResult ExtractIntegerMapHexahedra(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const Eigen::MatrixXi& tetrahedra);

} // namespace shape
