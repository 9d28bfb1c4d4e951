#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>

#include <array>
#include <vector>

namespace shape
{

/**
 * The hexahedra around a point, as a function of where it is:
 *
 *   E(x) = sum over the corners that x belongs to of exp(sharpness (1 - s)),
 *
 * s being the determinant of a corner's three edges divided by their lengths, where it is positive
 * by sqrt(length^2 + least^2): the scaled Jacobian alone would let edges shrink to nothing. least
 * is 0.05 of an edge of the hexahedron, and stays so while points move: else the stars would not be
 * parts of one energy, and lowering them by turns would lead nowhere. (Where it is negative,
 * shrinking must not help.) Any place has a value, also where hexahedra are inverted. The greater
 * the sharpness, the more it is the worst corner that counts: log(E) / sharpness tends to 1 - min
 * s.
 */
class StarEnergy
{
public:
  /// Hexahedra whose corners are beside each other in memory.
  using Corners = Eigen::Matrix<int, Eigen::Dynamic, 8, Eigen::RowMajor>;

  /// around: the hexahedra of a point, each with the corner that it is; leastSquares: least^2 of
  /// each hexahedron.
  StarEnergy(const Eigen::Matrix3Xd& points, const Corners& hexahedra,
    const Eigen::VectorXd& leastSquares, const std::vector<std::array<int, 2>>& around);

  /// least^2 of each hexahedron.
  static Eigen::VectorXd MinimumSquares(const HexMesh& mesh);

  double Value(const Eigen::Vector3d& x, double sharpness) const;

  struct Expansion
  {
    double Value = 0.0;
    Eigen::Vector3d Gradient = Eigen::Vector3d::Zero();
    /// A positive definite stand-in for the second derivative: exact in the first derivatives of s.
    Eigen::Matrix3d Curvature = Eigen::Matrix3d::Zero();
  };
  Expansion Expand(const Eigen::Vector3d& x, double sharpness) const;

  /// The length of the longest edge from x to a neighbour.
  double Reach(const Eigen::Vector3d& x) const;

private:
  /// A hexahedron seen from one of its corners: the ends of the three edges from there, and the
  /// corners across the faces between the second and third of them, and so on around.
  struct View
  {
    std::array<Eigen::Vector3d, 3> Ends, Across;
    double MinimumSquare;
  };
  boost::container::small_vector<View, 12> Views; // 8 at most points
};

} // namespace shape
