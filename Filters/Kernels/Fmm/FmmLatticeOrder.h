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

/// Positions in Morton order (G. M. Morton, 1966), sorted by the octant of their cube that they lie
/// in, then by the octant within that octant, and so on. The positions in one box of the subdivided
/// lattice are therefore contiguous.
struct FmmLatticeOrder
{
  static constexpr int Halvings = 16; ///< number of subdivisions that a key stores
  static constexpr int Roots = 27;    ///< number of cubes: the root and those that touch it

  /// For each position, its octants at all subdivisions of its cube, each in three bits. The keys
  /// of one cube are ascending.
  std::vector<std::uint64_t> Keys;
  std::vector<int> Ids;
  /// The index of the first position in each cube, then the number of positions. The root is cube
  /// (0, 0, 0); the coordinates of the cubes that touch it are -1, 0 or 1. Cube (x, y, z) has
  /// number 9 (x + 1) + 3 (y + 1) + z + 1. Positions before RootStart[0] lie in none of the cubes.
  std::vector<int> RootStart;
};

/// Sorts positions (n x 3). A position counts as inside the root if it lies outside by less than
/// 1e-9 times the root's edge length.
FmmLatticeOrder OrderOnLattice(const Eigen::MatrixXd& positions, const Lattice& lattice);

} // namespace shape
