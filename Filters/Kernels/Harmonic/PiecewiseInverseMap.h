#pragma once

#include "Harmonic/InverseMap.h"
#include "Harmonic/PiecewiseHarmonicMap.h"

#include <memory>
#include <vector>

namespace shape
{

/**
 * The preimages of points under a map of several layers: x with f(x) = y.
 *
 * They are searched for in each region by itself (InverseMap), the solid's outermost one first;
 * where the place that is found lies beyond a border, or in its skin, Newton's method goes on from
 * there with the whole map. The first that has the image asked for is taken. Used from any thread.
 */
class PiecewiseInverseMap
{
public:
  /// Throws as InverseMap does.
  explicit PiecewiseInverseMap(std::shared_ptr<const PiecewiseHarmonicMap> map,
    const InverseMapOptions& options = {}, const Progress& progress = {});

  /// points: n x 3, finite. Missed where no region leads to a preimage, but the point lies in the
  /// image of one. Throws Aborted.
  InverseMap::Result Find(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// The inverse of one region's map.
  const InverseMap& OfRegion(int region) const { return this->Inverses[region]; }
  double GoalOfMisses() const { return this->Goal; } ///< a preimage's, at most

private:
  std::shared_ptr<const PiecewiseHarmonicMap> Map;
  std::vector<InverseMap> Inverses; ///< by region
  double Goal = 0.0;                ///< a miss that is small enough
  double MaxStep = 0.0;
  int Iterations = 0;
};

} // namespace shape
