#pragma once

#include "Distance/SignedDistance.h"
#include "Geometry/Sampling.h"

#include <vector>

namespace shape
{

/**
 * The surfaces on which the charges of a harmonic map sit: one around the solid, at the offset
 * distance, and one in each of its voids, at the same distance or, in a narrow void, half as deep
 * as that is.
 */
class ChargeShells
{
public:
  /// boundary: closed, facing out of the solid: one component around it, any number around voids.
  /// offset: > 0, in its units. Throws InvalidInput if the offset is too small to sample,
  /// Aborted.
  ChargeShells(const Surface& boundary, double offset, const Progress& progress = {});

  double Area() const;                            ///< of all shells
  double Nearest() const { return this->Offset; } ///< the least distance of a shell; > 0

  /// `count` positions on the shells, and more if one would have less than Fewest. Those on each.
  static constexpr int Fewest = 24;
  std::vector<Eigen::MatrixXd> Sample(
    int count, SamplingMode mode, unsigned int seed, const Progress& progress = {}) const;

  /// All shells as one surface.
  Mesh Joined() const;

private:
  std::vector<Mesh> Shells;
  double Offset;
};

} // namespace shape
