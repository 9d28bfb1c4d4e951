#pragma once

#include "Distance/SignedDistance.h"

#include <optional>

namespace shape
{

struct BoundaryDistanceOptions
{
  /// If true, the surface must be closed, and the distance is negative inside its solid. If false,
  /// the surface may be open, and no distance is negative.
  bool Signed = true;
};

/**
 * The Euclidean distance to a triangulated surface.
 *
 * If Signed is true, each component of the surface may face inwards or outwards. A component inside
 * another one bounds a void in that component's solid (see OrientByNesting). The angle-weighted
 * pseudonormal determines the sign (see SignedDistance).
 */
class BoundaryDistance
{
public:
  /// Throws InvalidInput if the surface has no triangle or has a point that is not finite. With
  /// Signed, also throws InvalidInput if the surface is not closed or its components touch. Throws
  /// Aborted.
  explicit BoundaryDistance(const Surface& surface, const BoundaryDistanceOptions& options = {},
    const Progress& progress = {});

  /// Returns the distance of each of `points` (n x 3) from the surface, in its units. Throws
  /// InvalidInput if a point is not finite; Aborted.
  Eigen::VectorXd Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// exactly one of the two is set
private:
  std::optional<SignedDistance> WithSign;
  std::optional<SurfaceLocator> WithoutSign;
};

} // namespace shape
