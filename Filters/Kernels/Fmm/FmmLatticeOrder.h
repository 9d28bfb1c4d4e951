#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace shape
{

/// Cubes of edge length Side that fill space. The root is the cube with its lowest corner at
/// Origin.
struct Lattice
{
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  double Side = 1.0;
};

/// Positions in Morton order (G. M. Morton, 1966), sorted by octant of their cube, then by octant
/// of that octant, and so on. So the positions in one box of the subdivided lattice are contiguous.
struct FmmLatticeOrder
{
  static constexpr int Halvings = 16; ///< number of subdivisions that a key stores
  static constexpr int Roots = 27;    ///< number of cubes: the root and those that touch it

  /// for each position, its octant at every subdivision of its cube, in three bits each; ascending
  /// within a cube
  std::vector<std::uint64_t> Keys;
  std::vector<int> Ids;
  /// The first index of each cube, and the end. The root is cube (0, 0, 0); the coordinates of the
  /// cubes that touch it are -1, 0 or 1. Cube (x, y, z) has number 9 (x + 1) + 3 (y + 1) + z + 1.
  /// Positions before RootStart[0] lie in none of the cubes.
  std::vector<int> RootStart;
};

/// Sorts positions (n x 3). A position outside the root, but within 1e-9 of its edge length, counts
/// as inside.
FmmLatticeOrder OrderOnLattice(const Eigen::MatrixXd& positions, const Lattice& lattice);

} // namespace shape
