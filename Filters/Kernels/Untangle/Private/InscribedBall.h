#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The half-space of positions x with (Normal, 1) . (x, Offset) >= 0. The normal has length 1.
template <typename Scalar>
struct HalfSpaceOf
{
  Eigen::Matrix<Scalar, 3, 1> Normal;
  Scalar Offset;
};

template <typename Scalar>
struct InscribedBallOf
{
  Eigen::Matrix<Scalar, 3, 1> Centre = Eigen::Matrix<Scalar, 3, 1>::Zero();
  Scalar Radius = 0.0;
};

using HalfSpace = HalfSpaceOf<double>;
using InscribedBall = InscribedBallOf<double>;

/**
 * Returns the largest ball in the intersection of half-spaces and the cube [-extent, extent]^3. Its
 * centre is the Chebyshev centre of the intersection. If the intersection is empty, the radius is
 * negative: then the greatest violation, -Radius, is as small as possible at the centre.
 *
 * The linear programme in centre and radius is solved by the incremental method of Seidel,
 * "Small-dimensional linear programming and convex hulls made easy" (1991), in an order that
 * depends only on the number of half-spaces. The expected time is linear in it. Results are subject
 * to rounding, so the caller checks them. Scalar: double or TwoDoubles.
 */
template <typename Scalar>
InscribedBallOf<Scalar> FindInscribedBall(
  const std::vector<HalfSpaceOf<Scalar>>& halfSpaces, double extent);

} // namespace shape
