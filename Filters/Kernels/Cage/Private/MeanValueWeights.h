#pragma once

#include "Cage/Private/CageTriangle.h"

#include <array>

namespace shape
{

/**
 * Returns the share of a triangle in the mean value weights of its corners at a position, up to a
 * factor that is common to all points of the cage (Ju, Schaefer and Warren, "Mean value coordinates
 * for closed triangular meshes", 2005, section 4). They are 0 if the position lies in the
 * triangle's plane; it must not lie on the triangle.
 *
 * The paper's mean vector is m = sum_k theta_k n_k / 2, where theta_k is the angle of edge k and
 * n_k the normal of the plane through it and x. The weights of the corners, w_i = m . N_i / det
 * with N_i the cross product of the other two corners, cancel near the plane. In coordinates of the
 * plane they are
 *
 *   w_i = b_i M / h + h / (2 A) sum_k theta_k e_k . e_i / (2 |e_k| rho_k),
 *
 * with the height h, the area A, the edges e_k, the barycentric coordinates b_i of x's projection,
 * the distances rho_k of the edges' lines, and M = m . n = h^2 (integral of 1 / r^4 over the
 * triangle).
 */
template <typename Number>
std::array<Number, 3> ComputeMeanValueShares(
  const CageTriangle& triangle, const TriangleView<Number>& view);

} // namespace shape
