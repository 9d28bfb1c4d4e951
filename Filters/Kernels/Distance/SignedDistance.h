#pragma once

#include "Search/ClosestPoint.h"

#include <memory>

namespace shape
{

/**
 * The distance to a closed surface, negative inside it.
 *
 * The sign is that of the angle-weighted pseudonormal at the closest point (Baerentzen and Aanaes,
 * "Signed distance computation using the angle weighted pseudonormal", 2005). It is correct if the
 * surface is closed, faces outwards and does not cross itself. If a triangle at the closest point
 * is degenerate and has no normal, the winding number decides.
 */
class SignedDistance
{
public:
  /// surface: closed, triangles counter-clockwise seen from outside (checked by the caller). Its
  /// search tree and pseudonormals are cached in it, so another distance to it costs nothing.
  explicit SignedDistance(const Surface& surface);

  struct Result
  {
    Eigen::VectorXd Distances; ///< n: negative inside
    ClosestPoints Closest;     ///< the closest points on the surface
  };

  /// points: n x 3, finite. Throws what SurfaceLocator::Find throws.
  Result Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  const SurfaceLocator& Locator() const { return this->Nearest; }

  /// The surface that distances are measured to.
  const Surface& GetSurface() const { return this->Nearest.GetSurface(); }

private:
  struct Pseudonormals;
  SurfaceLocator Nearest;
  std::shared_ptr<const Pseudonormals> Normals;
};

/// Returns the distance outside a closed surface up to which points belong to its domain, for each
/// of the closest points on `surface` (n); see FindPointsOutsideDomain.
Eigen::VectorXd ComputeDomainTolerances(
  const Surface& surface, const ClosestPoints& closest, double farthest);

/**
 * Finds the points (n x 3, finite) outside the domain that a closed, outward-facing surface bounds:
 * 1 outside, 0 inside or within the tolerance.
 *
 * The tolerance is a quarter of the longest edge of the closest triangle. It is at most `farthest`,
 * and at least 1e-6 of the longest edge of the surface's bounding box. A solid that was meshed
 * against the smooth surface protrudes from its facets by less than that, and its points belong to
 * the domain. `farthest` is half the distance of the charges: close to them a harmonic map is
 * meaningless.
 *
 * Throws Aborted.
 */
Eigen::VectorXi FindPointsOutsideDomain(const SignedDistance& boundary,
  const Eigen::MatrixXd& points, double farthest, const Progress& progress = {});

} // namespace shape
