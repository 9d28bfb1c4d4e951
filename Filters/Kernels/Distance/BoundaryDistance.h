#pragma once

#include "Distance/SignedDistance.h"

#include <optional>

namespace shape
{

struct BoundaryDistanceOptions
{
  /// Negative inside the solid that the surface bounds, which must be closed; else the distance is
  /// positive everywhere and the surface may be open.
  bool Signed = true;
};

/**
 * The Euclidean distance to a triangulated surface.
 *
 * With a sign, the surface is closed, of one or several components that face any way: a component
 * within another bounds a void in its solid (see OrientByNesting), and the sign is that of the
 * angle-weighted pseudonormal (see SignedDistance).
 */
class BoundaryDistance
{
public:
  /// Throws InvalidInput if the surface has no triangle or a point that is not finite, and with
  /// Signed if it is not closed or its components touch; Aborted.
  explicit BoundaryDistance(const Surface& surface, const BoundaryDistanceOptions& options = {},
    const Progress& progress = {});

  /// The distance of each of `points` (n x 3, in the surface's units). Throws InvalidInput if
  /// one is not finite, Aborted.
  Eigen::VectorXd Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

private:
  std::optional<SignedDistance> WithSign; ///< one of the two is there
  std::optional<SurfaceLocator> WithoutSign;
};

} // namespace shape
