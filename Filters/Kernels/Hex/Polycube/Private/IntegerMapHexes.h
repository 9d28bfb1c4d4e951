#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * Walks along straight lines through tetrahedra. Each step leads from a tetrahedron to the next
 * across their common face. All tetrahedra must be positive. Tetrahedra that are not adjacent may
 * overlap, because the walk only enters adjacent ones.
 */
class TetrahedralWalk
{
public:
  /// Keeps references to both arguments.
  TetrahedralWalk(const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra);

  struct Position
  {
    int Tetrahedron;
    Eigen::Vector4d Weights; ///< barycentric coordinates: >= 0, their sum is 1
    bool Arrived;            ///< false if the walk ended at the boundary
    /// The corner opposite the boundary face where the walk ended, or -1 if it ended elsewhere.
    int Face = -1;
  };

  /// Walks from a position in a tetrahedron to another position. Returns where the walk ends.
  Position Go(int tetrahedron, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  /// Returns the barycentric coordinates of a position in a tetrahedron.
  Eigen::Vector4d Weights(int tetrahedron, const Eigen::Vector3d& position) const;

private:
  const Eigen::MatrixXd& Points;
  const Eigen::MatrixXi& Tetrahedra;
  std::vector<std::array<int, 4>> Neighbours; ///< across the face opposite each corner, or -1
};

/// Hexahedra, and where their points lie on the polycube and in the tetrahedra.
struct IntegerMapHexesResult
{
  HexMesh Solid;
  Eigen::MatrixXd Positions;  ///< n x 3: integer positions on the polycube
  Eigen::VectorXi Tetrahedra; ///< n: the tetrahedron that contains each point
  Eigen::MatrixXd Weights;    ///< n x 4: barycentric coordinates in this tetrahedron
  bool Overlaps = false;      ///< whether a cell of the grid occurs several times
};

/**
 * Extracts the hexahedra that a map of tetrahedra takes to the unit cells of the integer grid. The
 * map must be positive on every tetrahedron, and must take each boundary triangle into a plane at
 * an integer coordinate. The images of tetrahedra may overlap, so adjacent cells are found by walks
 * through the tetrahedra, not by coordinates.
 *
 * points, images (n x 3): the points of the tetrahedra and their images. tetrahedra: m x 4. Throws
 * SolveFailure if there is no cell, or if walks contradict each other.
 */
IntegerMapHexesResult ExtractIntegerMapHexahedra(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const Eigen::MatrixXi& tetrahedra);

} // namespace shape
