#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The half-space of positions x with (Normal, 1) . (x, Offset) >= 0. The normal has length 1.
struct HalfSpace
{
  Eigen::Vector3d Normal;
  double Offset;

  double Distance(const Eigen::Vector3d& x) const { return this->Normal.dot(x) + this->Offset; }
};

struct InscribedBall
{
  Eigen::Vector3d Centre = Eigen::Vector3d::Zero();
  double Radius = 0.0;
};

/**
 * Returns the largest ball in the intersection of half-spaces and the cube [-extent, extent]^3. Its
 * centre is the Chebyshev centre of the intersection. If the intersection is empty, the radius is
 * negative: then the greatest violation, -Radius, is as small as possible at the centre.
 *
 * The linear programme in centre and radius is solved by the incremental method of Seidel,
 * "Small-dimensional linear programming and convex hulls made easy" (1991), in an order that
 * depends only on the number of half-spaces. The expected time is linear in it. Results are subject
 * to rounding, so the caller checks them.
 */
InscribedBall FindInscribedBall(const std::vector<HalfSpace>& halfSpaces, double extent);

} // namespace shape
