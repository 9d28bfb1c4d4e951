#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>
#include <boost/container/small_vector.hpp>

#include <array>
#include <vector>

namespace shape
{

/// Up to eight hexahedra around a point, each seen from the corner that is the point. Coordinate c
/// of vector k of hexahedron i is stored at [k][c][i]. Unused entries repeat a used one.
struct StarBlock
{
  static constexpr int Size = 8;
  using Numbers = std::array<double, Size>;
  using Vectors = std::array<std::array<Numbers, 3>, 3>;

  Vectors Ends; ///< the ends of the three edges from the corner
  /// For each of the three faces at the corner, the diagonally opposite corner of the face. The
  /// face of edges 2 and 3 comes first, and the others follow in cyclic order.
  Vectors Across;
  /// At each end: the cross product of the two edges that do not lead to the corner, with the sign
  /// for which the determinant is the product with the edge from the corner to the end.
  Vectors Normals;
  std::array<Numbers, 3> Squares; ///< at each end: the product of their squared lengths
  /// The same with `minimum` added to each squared length.
  std::array<Numbers, 3> LongerSquares;
  Numbers MinimumSquares; ///< minimum^2, see StarEnergy
  Numbers Weights;        ///< 1, or 0 if the entry is unused
};

/**
 * The energy of the hexahedra around a point, as a function of the point's position x:
 *
 *   E(x) = sum over the corners that x belongs to of exp(sharpness (1 - s)).
 *
 * s is the determinant of a corner's three edges, divided by the product of their lengths. If the
 * determinant is not negative, each length is replaced by sqrt(length^2 + minimum^2): otherwise
 * edges could shrink to nothing at no cost. If the determinant is negative, lengths are not
 * changed, so that shrinking does not lower the energy.
 *
 * minimum is 0.05 times the mean edge length of the hexahedron. It is not updated while points
 * move. Otherwise the energies around different points would not be parts of one total energy, and
 * lowering one after another would not converge.
 *
 * The energy is defined for any position, even if hexahedra are inverted. The greater the
 * sharpness, the more the worst corner dominates: log(E) / sharpness tends to 1 - min s.
 *
 * Several hexahedra are evaluated at once (Highway): four corners of each depend on x.
 */
class StarEnergy
{
public:
  /// Hexahedra whose corners are contiguous in memory.
  using Corners = Eigen::Matrix<int, Eigen::Dynamic, 8, Eigen::RowMajor>;

  /// around: the hexahedra around the point, each with the index of the point among its corners.
  /// leastSquares: minimum^2 of each hexahedron.
  StarEnergy(const Eigen::Matrix3Xd& points, const Corners& hexahedra,
    const Eigen::VectorXd& leastSquares, const std::vector<std::array<int, 2>>& around);

  /// Returns minimum^2 of each hexahedron.
  static Eigen::VectorXd MinimumSquares(const HexMesh& mesh);

  double Value(const Eigen::Vector3d& x, double sharpness) const;

  struct Expansion
  {
    double Value = 0.0;
    Eigen::Vector3d Gradient = Eigen::Vector3d::Zero();
    /// A positive definite approximation of the Hessian. The terms with first derivatives of s are
    /// exact, and those with second derivatives are approximated.
    Eigen::Matrix3d Curvature = Eigen::Matrix3d::Zero();
    double Reach = 0.0; ///< the length of the longest edge from x to a neighbour
  };
  Expansion Expand(const Eigen::Vector3d& x, double sharpness) const;

private:
  int Count;                                           ///< the number of hexahedra
  boost::container::small_vector<StarBlock, 2> Blocks; // most points have 8 hexahedra
};

} // namespace shape
