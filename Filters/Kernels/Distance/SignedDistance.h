#pragma once

#include "Search/ClosestPoint.h"

#include <memory>

namespace shape
{

/**
 * The distance to a closed surface, negative inside it.
 *
 * The angle-weighted pseudonormal at the closest point determines the sign (Baerentzen and Aanaes,
 * "Signed distance computation using the angle weighted pseudonormal", 2005). The sign is correct
 * if the surface is closed, faces outwards and does not cross itself. If a triangle at the closest
 * point is degenerate and has no normal, the winding number decides.
 */
class SignedDistance
{
public:
  /// surface: closed, triangles counter-clockwise seen from outside (checked by the caller). The
  /// search tree and the pseudonormals are cached in the surface, so another SignedDistance of the
  /// same surface costs nothing.
  explicit SignedDistance(const Surface& surface);

  struct Result
  {
    Eigen::VectorXd Distances; ///< n: negative inside
    ClosestPoints Closest;     ///< the closest points on the surface
  };

  /// points: n x 3, finite. Throws the exceptions of SurfaceLocator::Find.
  Result Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  const SurfaceLocator& Locator() const { return this->Nearest; }

  /// The surface that distances are measured to.
  const Surface& GetSurface() const { return this->Nearest.GetSurface(); }

private:
  struct Pseudonormals;
  SurfaceLocator Nearest;
  std::shared_ptr<const Pseudonormals> Normals;
};

/// Returns the tolerance of FindPointsOutsideDomain at each of the n closest points on `surface`.
Eigen::VectorXd ComputeDomainTolerances(
  const Surface& surface, const ClosestPoints& closest, double farthest);

/**
 * Finds the points (n x 3, finite) outside the domain that a closed, outward-facing surface bounds.
 * Returns 1 for a point outside, and 0 for a point inside or within the tolerance (n values).
 *
 * The tolerance is a quarter of the longest edge of the closest triangle. It is at most `farthest`,
 * and at least 1e-6 of the longest edge of the surface's bounding box. The points of a solid that
 * was meshed from the smooth surface lie outside the facets by less than this, so they count as
 * inside. For a harmonic map, `farthest` is half the distance of its charges from the boundary,
 * because the map is meaningless close to a charge.
 *
 * Throws Aborted.
 */
Eigen::VectorXi FindPointsOutsideDomain(const SignedDistance& boundary,
  const Eigen::MatrixXd& points, double farthest, const Progress& progress = {});

} // namespace shape
