#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * Walks along straight lines through tetrahedra, from one to the next across their faces. All
 * tetrahedra are positive, but some that are not adjacent may overlap; the walk only crosses to
 * adjacent ones.
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
    bool Arrived;            ///< false if the walk met the boundary and ended there
    int Face = -1;           ///< the corner opposite the boundary face that it met, or -1
  };

  /// Walks from a position in a tetrahedron to another position.
  Position Go(int tetrahedron, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  /// Returns the barycentric coordinates of a position in a tetrahedron.
  Eigen::Vector4d Weights(int tetrahedron, const Eigen::Vector3d& position) const;

private:
  const Eigen::MatrixXd& Points;
  const Eigen::MatrixXi& Tetrahedra;
  std::vector<std::array<int, 4>> Neighbours; ///< across the face opposite each corner, or -1
};

/// Hexahedra, and the positions of their points on the polycube.
struct IntegerMapHexesResult
{
  HexMesh Solid;
  Eigen::MatrixXd Positions;  ///< n x 3: integers
  Eigen::VectorXi Tetrahedra; ///< n: the tetrahedron that contains each point
  Eigen::MatrixXd Weights;    ///< n x 4: the point's barycentric coordinates in it
  bool Overlaps = false;      ///< whether some cells of the grid occur several times
};

/**
 * Extracts the hexahedra that a map of tetrahedra takes to the unit cells of the integer grid. The
 * map is positive on every tetrahedron and takes each boundary triangle into a plane of integer
 * coordinate. The images may overlap, so neighbours are found by walks through the tetrahedra, not
 * by coordinates.
 *
 * points, images: n x 3. tetrahedra: m x 4. Throws SolveFailure if there is no cell or if walks
 * contradict each other.
 */
IntegerMapHexesResult ExtractIntegerMapHexahedra(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const Eigen::MatrixXi& tetrahedra);

} // namespace shape
