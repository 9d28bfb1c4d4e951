#pragma once

#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <functional>
#include <set>
#include <vector>

namespace shape
{

/**
 * Collects the curves of a surface that hexahedra are too coarse for. Where several curves may be
 * the reason, the shortest is taken: less of the creases is then given up, and matching the others
 * tells whether it was the right one.
 */
class UnmatchedCurves
{
public:
  /// Keeps references to both.
  UnmatchedCurves(const Surface& surface, const SurfaceFeatures& features);

  void Add(int curve) { this->Curves.insert(curve); }

  /// Adds the shortest curve that ends at a corner (a point of the surface).
  void AddAtCorner(int corner);

  /// Adds the curve along which a patch is united with another: the shortest around it.
  void AddAround(int patch);

  /// Adds the shortest curve between two of some patches. If there is none, it adds the curve of
  /// one of them that is closest to a position.
  void AddBetween(const std::set<int>& patches, const Eigen::RowVector3d& position);

  const std::set<int>& Indices() const { return this->Curves; }

private:
  /// Adds the acceptable curve of least cost, unless one of the acceptable curves is in the
  /// collection already. Returns whether any curve is acceptable.
  bool AddBest(const std::function<bool(const FeatureCurve&)>& accepts,
    const std::function<double(std::size_t)>& cost);

  const Surface& Whole;
  const SurfaceFeatures& Features;
  std::vector<double> Lengths; ///< of each curve
  std::set<int> Curves;
};

} // namespace shape
