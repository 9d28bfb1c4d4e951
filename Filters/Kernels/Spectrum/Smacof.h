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
  double Tolerance = 1e-4; ///< stops when the relative change of the stress is smaller; >= 0
};

/// Some points of a surface, and their positions in the embedding.
struct EmbeddedSamples
{
  std::vector<int> Points;
  Eigen::MatrixXd Positions; ///< s x Dimensions, in the model's units
};

/**
 * Computes positions whose Euclidean distances are as close as possible to the distances along a
 * surface. It minimizes the sum of squared differences between samples by majorisation (SMACOF: de
 * Leeuw, "Applications of convex analysis to multidimensional scaling", 1977), starting from
 * classical scaling. EmbedByClassicalMds fits inner products instead, which makes distances that no
 * Euclidean space has too long.
 *
 * surface: a consistently oriented 2-manifold of one component, open or closed. Throws
 * InvalidInput, SolveFailure, Aborted.
 */
EmbeddedSamples EmbedSamples(
  const Surface& surface, const SmacofOptions& options = {}, const Progress& progress = {});

/**
 * Extends the positions of the samples to all points by the smoothest interpolating functions,
 * which minimize tr X' L M^-1 L X (Rustamov, "Multiscale biharmonic kernels", 2011). Returns
 * n x Dimensions; 0 at points without a triangle. The samples may come from a coarser surface.
 * Throws SolveFailure.
 */
Eigen::MatrixXd ExtendBiharmonically(const Surface& surface, const EmbeddedSamples& samples);

/// Combines both: EmbedSamples, then ExtendBiharmonically to all points.
Eigen::MatrixXd EmbedBySmacof(
  const Surface& surface, const SmacofOptions& options = {}, const Progress& progress = {});

} // namespace shape
