#pragma once

#include "Harmonic/InverseMap.h"
#include "Harmonic/PiecewiseHarmonicMap.h"

#include <memory>
#include <vector>

namespace shape
{

/**
 * Inverts a map f with several regions: for each point y it finds a preimage x, f(x) = y.
 *
 * Each region is searched separately (InverseMap), the outermost first. The preimage found may lie
 * beyond a border or in the skin, where the complete map f differs from the region's map. Newton's
 * method therefore continues from there with f. The first position whose image is within the
 * tolerance of y is returned.
 *
 * If the map has a repair, y is first searched in the images of the core's tetrahedra, where the
 * inverse is linear. Otherwise the preimage by the charges counts if it is outside the repair. The
 * rest is found by Newton's method with f, from the closest image of a tetrahedron of the ring.
 *
 * Can be used from several threads.
 */
class PiecewiseInverseMap
{
public:
  /// Throws the same exceptions as InverseMap.
  explicit PiecewiseInverseMap(std::shared_ptr<const PiecewiseHarmonicMap> map,
    const InverseMapOptions& options = {}, const Progress& progress = {});

  /// Finds the preimages of points (n x 3, finite). The state is Missed if a point lies in the
  /// image of a region, but no search finds a preimage. Throws Aborted.
  InverseMap::Result Find(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// Returns the inverse of one region's map.
  const InverseMap& OfRegion(int region) const { return this->Inverses[region]; }
  double GoalOfMisses() const { return this->Goal; } ///< maximum of |f(x) - y| at a preimage

private:
  void PrepareRepair();
  InverseMap::Result FindInRepaired(const Eigen::MatrixXd& points, const Progress& progress) const;

  std::shared_ptr<const PiecewiseHarmonicMap> Map;
  std::vector<InverseMap> Inverses; ///< one for each region
  double Goal = 0.0;                ///< maximum of |f(x) - y| at a preimage
  double MaxStep = 0.0;
  int Iterations = 0;
  // The maps from the images to the tetrahedra of a repair; null where there are none.
  std::unique_ptr<const FiniteElementMap> Core, Ring;
};

} // namespace shape
