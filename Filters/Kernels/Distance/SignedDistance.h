#pragma once

#include "Search/ClosestPoint.h"

#include <memory>

namespace shape
{

/**
 * The distance to a closed surface, negative inside it.
 *
 * The sign is that of the angle-weighted pseudonormal at the closest point (Baerentzen and Aanaes,
 * "Signed distance computation using the angle weighted pseudonormal", 2005), right wherever the
 * surface is closed, outward facing and does not cross itself. Where a triangle at the closest
 * point is flat, and has no normal, the winding number decides.
 */
class SignedDistance
{
public:
  /// surface: closed, triangles counter-clockwise when seen from outside (the caller has checked).
  /// Its search tree and pseudonormals are kept with it: a second distance of it costs nothing.
  explicit SignedDistance(const Surface& surface);

  struct Result
  {
    Eigen::VectorXd Distances; ///< n: negative inside
    ClosestPoints Closest;     ///< of the surface
  };

  /// points: n x 3, finite. Throws as SurfaceLocator::Find.
  Result Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  const SurfaceLocator& Locator() const { return this->Nearest; }

  /// The surface that distances are to.
  const Surface& GetSurface() const { return this->Nearest.GetSurface(); }

private:
  struct Pseudonormals;
  SurfaceLocator Nearest;
  std::shared_ptr<const Pseudonormals> Normals;
};

/// How far outside a closed surface points belong to its domain all the same, given the closest
/// points of `surface` (n): see FindPointsOutsideDomain.
Eigen::VectorXd ComputeDomainTolerances(
  const Surface& surface, const ClosestPoints& closest, double farthest);

/**
 * Which of `points` (n x 3, finite) lie outside the domain that a closed, outward facing surface
 * bounds: 1 outside, 0 inside or within the tolerance.
 *
 * The tolerance is a quarter of the longest edge of the closest triangle, at most `farthest` and at
 * least 1e-6 of the surface's longest side: a solid that was meshed against the smooth surface
 * sticks out of its facets by less than that, and its points belong to the domain. `farthest` is
 * half the distance of the charges: near them a harmonic map means nothing.
 *
 * Throws Aborted.
 */
Eigen::VectorXi FindPointsOutsideDomain(const SignedDistance& boundary,
  const Eigen::MatrixXd& points, double farthest, const Progress& progress = {});

} // namespace shape
