#pragma once

#include "Distance/SignedDistance.h"

#include <optional>

namespace shape
{

struct BoundaryDistanceOptions
{
  /// If true, the distance is negative inside the solid that the surface bounds, which must be
  /// closed. If false, the distance is positive everywhere, and the surface may be open.
  bool Signed = true;
};

/**
 * The Euclidean distance to a triangulated surface.
 *
 * If signed, the surface must be closed; its components may face either way. A component inside
 * another bounds a void in its solid (see OrientByNesting). The sign is that of the angle-weighted
 * pseudonormal (see SignedDistance).
 */
class BoundaryDistance
{
public:
  /// Throws InvalidInput if the surface has no triangle or a point that is not finite. With Signed,
  /// throws it also if the surface is not closed or its components touch. Throws Aborted.
  explicit BoundaryDistance(const Surface& surface, const BoundaryDistanceOptions& options = {},
    const Progress& progress = {});

  /// Returns the distance of each of `points` (n x 3, in the surface's units). Throws InvalidInput
  /// if one is not finite; Aborted.
  Eigen::VectorXd Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

private:
  std::optional<SignedDistance> WithSign; ///< exactly one of the two is set
  std::optional<SurfaceLocator> WithoutSign;
};

} // namespace shape
