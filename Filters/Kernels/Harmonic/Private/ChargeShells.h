#pragma once

#include "Distance/SignedDistance.h"
#include "Geometry/Sampling.h"

#include <vector>

namespace shape
{

/**
 * The surfaces on which the charges of a harmonic map lie. One is around the solid, at the offset
 * distance. One is in each void, at the offset distance or at half the void's depth, whichever is
 * smaller.
 */
class ChargeShells
{
public:
  /// boundary: closed, facing out of the solid; one component is around the solid, the others are
  /// around voids. offset: > 0, in the boundary's units. Throws InvalidInput if the offset is too
  /// small to sample; Aborted.
  ChargeShells(const Surface& boundary, double offset, const Progress& progress = {});

  double Area() const;                            ///< total area of all shells
  double Nearest() const { return this->Offset; } ///< minimum distance of a shell; > 0

  /// Samples `count` positions on the shells. A shell gets at least Fewest, so there may be more
  /// than `count`. Returns one matrix for each shell.
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
