#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Computes positions whose Euclidean distances approximate the distances along a surface. It
 * applies classical multidimensional scaling to samples, and extends the result to all other points
 * by their distances from the samples (de Silva and Tenenbaum, "Sparse multidimensional scaling
 * using landmark points", 2004, section 2). In three dimensions this is Elad and Kimmel's canonical
 * form (2003), which bending changes little. Distances are those of HeatGeodesics. The samples are
 * farthest points along edges, starting with the surface's first point.
 *
 * surface: a consistently oriented 2-manifold of one component, open or closed. samples: more than
 * dimensions. Returns n x dimensions, in the model's units, centred on the samples; 0 at points
 * without a triangle. The columns are sorted by descending eigenvalue; columns without a positive
 * eigenvalue are 0. A column's value of largest magnitude is positive. Throws InvalidInput,
 * SolveFailure, Aborted.
 */
Eigen::MatrixXd EmbedByClassicalMds(
  const Surface& surface, int dimensions, int samples = 500, const Progress& progress = {});

/// Returns the axes of classical scaling (s x dimensions). Positions are -1/2 times the squared
/// distances from the samples, minus their means, times these axes. squares: s x s, symmetric:
/// squared distances between the samples. Columns without a positive eigenvalue are 0.
Eigen::MatrixXd ComputeScalingAxes(const Eigen::MatrixXd& squares, int dimensions);

} // namespace shape
