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
 * form (2003); bending the surface changes it little. HeatGeodesics computes the distances. The
 * first sample is the surface's first point; each further sample is the point farthest from the
 * previous ones along edges.
 *
 * surface: a consistently oriented 2-manifold of one component, open or closed. samples: the number
 * of samples; > dimensions. Returns n x dimensions, in the model's units; 0 at points without a
 * triangle. The mean over the samples is 0. The columns are sorted by descending eigenvalue;
 * columns without a positive eigenvalue are 0. A column's value of largest magnitude is positive.
 * Throws InvalidInput if the surface does not meet these conditions; SolveFailure and Aborted.
 */
Eigen::MatrixXd EmbedByClassicalMds(
  const Surface& surface, int dimensions, int samples = 500, const Progress& progress = {});

/// Returns the axes A of classical scaling (s x dimensions). The position of a point is -1/2 (d -
/// m) A, where the row d contains its squared distances from the samples, and m is the mean of d
/// over the samples. squares: s x s, symmetric: the squared distances between the samples. Columns
/// without a positive eigenvalue are 0.
Eigen::MatrixXd ComputeScalingAxes(
  const Eigen::MatrixXd& squares, int dimensions, const Progress& progress);

} // namespace shape
