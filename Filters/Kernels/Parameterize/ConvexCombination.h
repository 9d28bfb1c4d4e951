#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// The weights w_ij with which each point i is the weighted mean of its neighbours j:
/// sum_j w_ij (x_j - x_i) = 0.
enum class CombinationWeights
{
  /// w_ij = 1 (Tutte 1963, "How to draw a graph"): never flips a triangle, but ignores the shape.
  Uniform = 0,
  /// w_ij = (cot a + cot b) / 2 with the angles a and b opposite the edge: the discrete harmonic
  /// map (Pinkall & Polthier 1993; Eck et al. 1995). A weight is negative if a + b > pi; then
  /// triangles may flip.
  Cotangent = 1,
  /// w_ij = (tan(a / 2) + tan(b / 2)) / |x_i - x_j| with the angles a and b at i on both sides of
  /// the edge (Floater 2003, "Mean value coordinates", equation 2.1). The weights are positive, so
  /// no triangle flips. They are not symmetric: w_ij and w_ji differ.
  MeanValue = 2
};

/**
 * Computes positions for the points of a surface. The points in `fixed` have given positions; each
 * other point is the weighted mean of its neighbours (a convex combination map if the weights are
 * positive). Cotangent and MeanValue weights leave a flat surface unchanged if its boundary is
 * fixed in place.
 *
 * surface: a manifold. Each component has at least one fixed point, and every point is a corner of
 * a triangle. fixed: k different points. positions: k x d. Returns n x d. Triangles without area
 * get the angles that ComputeTriangleAngles assigns to them. For MeanValue, an edge shorter than
 * 1e-6 of the mean edge length is treated as that long.
 *
 * For 100,000 points, the factorisation takes about 0.3 s (Cotangent, Uniform) or 0.9 s
 * (MeanValue). Throws SolveFailure if the factorisation
 * breaks down, and Aborted.
 */
Eigen::MatrixXd SolveConvexCombination(const Mesh& surface, CombinationWeights weights,
  const std::vector<int>& fixed, const Eigen::MatrixXd& positions, const Progress& progress = {});

} // namespace shape
