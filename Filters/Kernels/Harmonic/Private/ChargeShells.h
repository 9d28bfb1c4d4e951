#pragma once

#include "Distance/SignedDistance.h"
#include "Geometry/Sampling.h"

#include <vector>

namespace shape
{

/**
 * The surfaces that carry the charges of a harmonic map. One lies around the solid, at the offset
 * distance. One lies in each void, at the same distance or at half the void's depth if that is
 * smaller.
 */
class ChargeShells
{
public:
  /// boundary: closed, facing out of the solid; one component around it, any number around voids.
  /// offset: > 0, in its units. Throws InvalidInput if the offset is too small to sample; Aborted.
  ChargeShells(const Surface& boundary, double offset, const Progress& progress = {});

  double Area() const;                            ///< total area of all shells
  double Nearest() const { return this->Offset; } ///< minimum distance of a shell; > 0

  /// Samples `count` positions on the shells, and more if a shell would have fewer than Fewest.
  /// Returns one matrix for each shell.
  static constexpr int Fewest = 24;
  std::vector<Eigen::MatrixXd> Sample(
    int count, SamplingMode mode, unsigned int seed, const Progress& progress = {}) const;

  /// Returns all shells as one surface.
  Mesh Joined() const;

private:
  std::vector<Mesh> Shells;
  double Offset;
};

} // namespace shape
