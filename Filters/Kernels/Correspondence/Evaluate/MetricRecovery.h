#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct MetricRecoveryOptions
{
  /// Weight of the smoothness of the ratio of the metrics; > 0, dimensionless. Exact operators
  /// determine more with a smaller weight. Operators with errors need a larger one.
  double Smoothness = 1e-5;
};

/// The metric of the other surface on the triangles of the first one.
struct RecoveredMetric
{
  Eigen::VectorXd Areas; ///< m values, as the area operator determines them
  /// m x 3: length of the edge opposite each corner. Both triangles of an edge have the same.
  Eigen::MatrixXd Sides;
  int BrokenTriangles = 0; ///< triangles of no area, or whose lengths break the triangle inequality
};

/**
 * Recovers areas and edge lengths of a surface from its difference operators to `first` by two
 * linear systems (Corman et al., "Functional characterization of intrinsic and extrinsic geometry",
 * 2017). Mass matrices are linear in the areas of triangles. For given areas, stiffness matrices
 * are linear in the squares of edge lengths: the cotangent of the angle opposite the edge k is
 * (q_i + q_j - q_k) / (4 area), where q are squared lengths.
 *
 * The operators are truncated to k eigenfunctions, so they determine only what varies
 * as slowly as products of these. The ratio of the areas, and a symmetric tensor C in space
 * with q = e C e for each edge vector e of `first`, are therefore combinations of 2 k
 * eigenfunctions. A combination is penalised by Smoothness, times the square of its eigenvalue
 * divided by the largest one. The least squares have 2 k and 12 k unknowns, whatever the number of
 * triangles; their time is proportional to that number, and to k^3.
 *
 * first: a 2-manifold, open or closed. area, conformal: the operators (k x k) in the eigenbasis of
 * `first`, as MapDifference returns them. Throws InvalidInput if they are not k x k, not finite, or
 * if k is not larger than the number of components or exceeds the number of points; SolveFailure if
 * an area is recovered as negative; Aborted.
 */
RecoveredMetric RecoverMetric(const Surface& first, const Eigen::MatrixXd& area,
  const Eigen::MatrixXd& conformal, const MetricRecoveryOptions& options = {},
  const Progress& progress = {});

} // namespace shape
