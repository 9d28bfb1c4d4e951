#pragma once

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace shape
{

/// The Euclidean orbifolds of sphere type. The numbers are the orders of the rotations about the
/// cones: a cone of order k has the total angle 2 pi / k.
enum class OrbifoldType
{
  Square = 0,   ///< three cones, 4 2 4: the tile is a square
  Rhombus = 1,  ///< three cones, 3 3 3: the tile is a rhombus of two equilateral triangles
  Triangle = 2, ///< three cones, 6 3 2: the tile is an equilateral triangle
  Rectangle = 3 ///< four cones, 2 2 2 2: the tile is a rectangle, but any parallelogram would do
};

int GetConeCount(OrbifoldType type);

/// An orientation-preserving isometry of the plane: z is mapped to Turn z + Shift.
struct PlaneIsometry
{
  std::complex<double> Turn{ 1.0, 0.0 }; ///< modulus 1
  std::complex<double> Shift{ 0.0, 0.0 };
  std::complex<double> operator()(std::complex<double> z) const
  {
    return this->Turn * z + this->Shift;
  }
  /// Returns the composition that applies `other` first, then this.
  PlaneIsometry After(const PlaneIsometry& other) const
  {
    return { this->Turn * other.Turn, (*this)(other.Shift) };
  }
};

/**
 * The tile of an orbifold. Cutting the surface open along a path through its cones makes it a disk;
 * the tile is the image of this disk in the plane. On the tile's boundary, the first and the last
 * cone each have one position. Every other cone has two positions, one for each side of the path.
 * Traversed counter-clockwise, the boundary follows the path from the first cone to the last, with
 * the surface to its left, and then returns.
 */
struct OrbifoldTile
{
  OrbifoldType Type = OrbifoldType::Square;
  std::vector<std::complex<double>> There; ///< positions of the cones on the forward path
  std::vector<std::complex<double>> Back;  ///< positions of the cones on the return path
  /// For each leg of the path, from one cone to the next: the isometry that maps the leg's image on
  /// the forward path to its image on the return path.
  std::vector<PlaneIsometry> Legs;
};

OrbifoldTile BuildOrbifoldTile(OrbifoldType type);

/**
 * Legs generates a group. Returns the isometries of this group that move `centre` by at most
 * `radius`. They are sorted by the distance by which they move `centre`; the identity is first. The
 * images of the tile under the whole group cover the plane once.
 */
std::vector<PlaneIsometry> ComputeOrbifoldMotions(
  const OrbifoldTile& tile, std::complex<double> centre, double radius);

} // namespace shape
