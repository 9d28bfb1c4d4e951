#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// By which weights w_ij a point is the mean of its neighbours: sum_j w_ij (x_j - x_i) = 0.
enum class CombinationWeights
{
  /// w_ij = 1 (Tutte 1963, "How to draw a graph"): never flips, and sees nothing of the shape.
  Uniform = 0,
  /// w_ij = (cot a + cot b) / 2 over the angles opposite the edge: the discrete harmonic map
  /// (Pinkall & Polthier 1993; Eck et al. 1995). Negative where a + b > pi, and then it can flip.
  Cotangent = 1,
  /// w_ij = (tan(a / 2) + tan(b / 2)) / |x_i - x_j| over the angles at i beside the edge (Floater
  /// 2003, "Mean value coordinates", equation 2.1): positive, so it never flips; not symmetric.
  MeanValue = 2
};

/**
 * Positions for the points of a surface, of which those in `fixed` are given and each other one is
 * the weighted mean of its neighbours (a convex combination map if the weights are positive). A
 * surface that lies flat in the plane is reproduced by Cotangent and MeanValue.
 *
 * surface: a manifold, each component with at least one fixed point; every point used; of any
 * size. fixed: k different points; positions: k x d. Returns n x d. Triangles without area count
 * with the angles that ComputeTriangleAngles gives them, and edges as no shorter than 1e-6 of the
 * mean.
 *
 * Each factorisation is one library call that cannot be interrupted: at 100,000 points 0.3 s
 * (Cotangent, Uniform) and 0.9 s (MeanValue). Throws SolveFailure if it breaks down, Aborted.
 */
Eigen::MatrixXd SolveConvexCombination(const Mesh& surface, CombinationWeights weights,
  const std::vector<int>& fixed, const Eigen::MatrixXd& positions, const Progress& progress = {});

} // namespace shape
