#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace shape
{

/// Cubes of side `Side` that fill space, one of them, the root, with its lowest corner at Origin.
struct Lattice
{
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  double Side = 1.0;
};

/// Positions along the curve that visits the eight halves of a cube one after the other, each in
/// the same way (G. M. Morton, 1966): what lies in one box of the halved lattice stands side by
/// side.
struct FmmLatticeOrder
{
  static constexpr int Halvings = 16; ///< that a key tells
  static constexpr int Roots = 27;    ///< the root and the cubes that touch it

  std::vector<std::uint64_t> Keys; ///< inside of their cube, three bits a halving, rising
  std::vector<int> Ids;
  /// The first place of each cube, (x + 1, y + 1, z + 1) in base 3 with the root at the origin, and
  /// the end; the places before the first cube's lie in none of them.
  std::vector<int> RootStart;
};

/// places: n x 3. The root takes in what lies within 1e-9 of its sides.
FmmLatticeOrder OrderOnLattice(const Eigen::MatrixXd& positions, const Lattice& lattice);

} // namespace shape
