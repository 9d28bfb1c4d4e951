#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Positions whose straight distances are near the distances along a surface:
 * classical multidimensional scaling of samples, and all other points by their distances from
 * these (de Silva and Tenenbaum, "Sparse multidimensional scaling using landmark points", 2004,
 * section 2). In three dimensions, Elad and Kimmel's canonical form (2003): how a surface is bent
 * changes it little. Distances are those of HeatGeodesics; samples are farthest from each other
 * along edges, the first is the surface's first point.
 *
 * surface: a consistently oriented 2-manifold of one component, open or closed. Returns n x
 * dimensions, in the model's units, centred on the samples; columns in descending order of their
 * eigenvalues, 0 from the first that is not positive on; 0 at points without a triangle. A column's
 * value of largest magnitude is positive. samples: > dimensions. Throws InvalidInput, SolveFailure,
 * Aborted.
 */
Eigen::MatrixXd EmbedByClassicalMds(
  const Surface& surface, int dimensions, int samples = 500, const Progress& progress = {});

/// What classical scaling makes positions of: squared distances from the samples, less their means,
/// times this (s x dimensions), times -1/2. squares: s x s, symmetric, between the samples. Columns
/// without a positive eigenvalue are 0.
Eigen::MatrixXd ComputeScalingAxes(const Eigen::MatrixXd& squares, int dimensions);

} // namespace shape
