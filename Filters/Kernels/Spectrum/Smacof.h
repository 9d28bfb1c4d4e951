#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct SmacofOptions
{
  int Dimensions = 8;      ///< >= 1
  int Samples = 500;       ///< > Dimensions
  int Iterations = 200;    ///< maximum number of majorisation steps; >= 0
  double Tolerance = 1e-4; ///< stops when the relative change of the stress is less than this; >= 0
};

/// Some points of a surface, called samples, and their positions in the embedding.
struct EmbeddedSamples
{
  std::vector<int> Points;
  Eigen::MatrixXd Positions; ///< s x Dimensions, in the model's units
};

/**
 * Computes positions of samples whose Euclidean distances are as close as possible to their
 * distances along the surface. The sum of squared differences is minimized by majorisation (SMACOF:
 * de Leeuw, "Applications of convex analysis to multidimensional scaling", 1977), starting from
 * classical scaling. EmbedByClassicalMds fits inner products instead. If no Euclidean space has the
 * given distances, those of EmbedByClassicalMds are too long.
 *
 * surface: a consistently oriented 2-manifold of one component, open or closed. Throws InvalidInput
 * if it is not; SolveFailure and Aborted.
 */
EmbeddedSamples EmbedSamples(
  const Surface& surface, const SmacofOptions& options = {}, const Progress& progress = {});

/**
 * Extends the positions of the samples to all points. The coordinates X are the smoothest
 * interpolating functions: they minimize tr X^T L M^-1 L X (Rustamov, "Multiscale biharmonic
 * kernels", 2011). Returns n x Dimensions; 0 at points without a triangle. The samples may have
 * been embedded on a coarser surface. Throws SolveFailure.
 */
Eigen::MatrixXd ExtendBiharmonically(
  const Surface& surface, const EmbeddedSamples& samples, const Progress& progress = {});

/// Returns the result of EmbedSamples, extended to all points by ExtendBiharmonically.
Eigen::MatrixXd EmbedBySmacof(
  const Surface& surface, const SmacofOptions& options = {}, const Progress& progress = {});

} // namespace shape
