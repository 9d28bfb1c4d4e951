#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace shape
{

/// Cubes with edge length `Side` that fill space. One of them, the root, has its lowest corner at
/// Origin.
struct Lattice
{
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  double Side = 1.0;
};

/// Positions in Morton order (G. M. Morton, 1966), a curve that recursively visits the eight
/// octants of a cube in the same order. Positions in one box of the subdivided lattice are
/// contiguous.
struct FmmLatticeOrder
{
  static constexpr int Halvings = 16; ///< number of subdivisions that a key stores
  static constexpr int Roots = 27;    ///< number of cubes: the root and those that touch it

  /// position inside its cube, three bits per subdivision, ascending in each cube
  std::vector<std::uint64_t> Keys;
  std::vector<int> Ids;
  /// First index of each cube, and the end. Cube (x + 1, y + 1, z + 1) is numbered in base 3, with
  /// the root at the origin. The positions before the first cube's lie in none of the cubes.
  std::vector<int> RootStart;
};

/// positions: n x 3. The root includes positions within 1e-9 of its faces.
FmmLatticeOrder OrderOnLattice(const Eigen::MatrixXd& positions, const Lattice& lattice);

} // namespace shape
