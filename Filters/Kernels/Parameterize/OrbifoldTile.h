#pragma once

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace shape
{

/// The Euclidean orbifolds of sphere type: how many images of the tile meet at each cone.
enum class OrbifoldType
{
  Square = 0,   ///< three cones, 4 2 4: the tile is a square
  Rhombus = 1,  ///< three cones, 3 3 3: two equilateral triangles
  Triangle = 2, ///< three cones, 6 3 2: one equilateral triangle
  Rectangle = 3 ///< four cones, 2 2 2 2: a rectangle; any parallelogram serves as well
};

int GetConeCount(OrbifoldType type);

/// A motion of the plane that mirrors nothing: z goes to Turn z + Shift.
struct PlaneIsometry
{
  std::complex<double> Turn{ 1.0, 0.0 }; ///< of modulus 1
  std::complex<double> Shift{ 0.0, 0.0 };
  std::complex<double> operator()(std::complex<double> z) const
  {
    return this->Turn * z + this->Shift;
  }
  /// First `other`, then this.
  PlaneIsometry After(const PlaneIsometry& other) const
  {
    return { this->Turn * other.Turn, (*this)(other.Shift) };
  }
};

/**
 * The tile of an orbifold. Cut open along a path through its cones, the surface is a disk; the tile
 * is its image in the plane. First and last cones have one position on its boundary, those between
 * two: one for each side of the path. Counter-clockwise the boundary runs along the path from its
 * first cone to its last, with the surface to the left, and back again.
 */
struct OrbifoldTile
{
  OrbifoldType Type = OrbifoldType::Square;
  std::vector<std::complex<double>> There; ///< of each cone on the way there
  std::vector<std::complex<double>> Back;  ///< and on the way back
  /// Of each leg of the path, from one cone to the next: the motion that takes its image on the way
  /// there to that on the way back.
  std::vector<PlaneIsometry> Legs;
};

OrbifoldTile BuildOrbifoldTile(OrbifoldType type);

/**
 * The motions of the group that the legs' motions generate that move `centre` by no more than
 * `radius`: the identity, and then by that distance, equal ones by turn. The plane is covered once
 * by the images of the tile under all motions.
 */
std::vector<PlaneIsometry> ComputeOrbifoldMotions(
  const OrbifoldTile& tile, std::complex<double> centre, double radius);

} // namespace shape
