#pragma once

#include "Search/ClosestPoint.h"

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
  explicit SignedDistance(const Mesh& surface);

  struct Result
  {
    Eigen::VectorXd Distances; ///< n: negative inside
    ClosestPoints Closest;     ///< of the surface
  };

  /// points: n x 3, finite. Throws as SurfaceLocator::Find.
  Result Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  const SurfaceLocator& Locator() const { return this->Surface; }

private:
  SurfaceLocator Surface;
  // NaN where a triangle is flat, or one beside the edge or the point.
  Eigen::MatrixXd TriangleNormals; ///< m x 3
  Eigen::MatrixXd EdgeNormals;     ///< 3m x 3: row 3 t + k is the edge opposite corner k of t
  Eigen::MatrixXd PointNormals;    ///< n x 3, angle-weighted
};

} // namespace shape
