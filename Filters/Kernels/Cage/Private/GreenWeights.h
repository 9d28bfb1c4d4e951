#pragma once

#include "Cage/Private/CageTriangle.h"

#include <array>

namespace shape
{

/// The share of a triangle in Green coordinates.
template <typename Number>
struct GreenShares
{
  std::array<Number, 3> Points; ///< phi of its corners, without the part of the solid angle
  Number SolidAngle;            ///< / 4 pi: each corner has it times Barycentric in addition
  Number Normal;                ///< psi
};

/**
 * Returns the integrals over a triangle in Green's third identity (Lipman, Levin and Cohen-Or,
 * "Green coordinates", 2008, equations 4 and 5): phi_i is the double layer potential of corner i's
 * hat function, and psi the single layer potential. Both are in closed form (Wilton et al.,
 * "Potential integrals for uniform and linear source distributions on polygonal and polyhedral
 * domains", 1984). With the height h, the edges e_k and their potentials l_k, the integrals of 1 /
 * r along them, and the solid angle Omega:
 *
 *   4 pi phi_i = b_i Omega + h / (2 A) sum_k e_i . e_k / |e_k| l_k,
 *   4 pi psi = sum_k beta_k l_k - h Omega.
 *
 * In the triangle's plane, Omega is 0 and phi_i is the mean of both sides of the plane.
 */
template <typename Number>
GreenShares<Number> ComputeGreenShares(
  const CageTriangle& triangle, const TriangleView<Number>& view);

} // namespace shape
