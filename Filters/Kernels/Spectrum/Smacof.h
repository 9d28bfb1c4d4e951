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
  int Iterations = 200;    ///< of the majorisation at most; >= 0
  double Tolerance = 1e-4; ///< relative change of the stress at which it ends; >= 0
};

/// Some points of a surface and where they are in the embedding.
struct EmbeddedSamples
{
  std::vector<int> Points;
  Eigen::MatrixXd Positions; ///< s x Dimensions, in the model's units
};

/**
 * Positions whose straight distances are as near as possible to the distances along a surface: the
 * minimum of the sum of squared differences between samples, by majorisation (SMACOF: de Leeuw,
 * "Applications of convex analysis to multidimensional scaling", 1977) from classical scaling.
 * Unlike EmbedByClassicalMds's, which fits inner products, distances that no flat space has are not
 * made too long.
 *
 * surface: a consistently oriented 2-manifold of one component, open or closed. Throws
 * InvalidInput, SolveFailure, Aborted.
 */
EmbeddedSamples EmbedSamples(
  const Surface& surface, const SmacofOptions& options = {}, const Progress& progress = {});

/**
 * Positions of all points by the smoothest functions through the samples, the minimum of
 * tr X' L M^-1 L X (Rustamov, "Multiscale biharmonic kernels", 2011): n x Dimensions; 0 at points
 * without a triangle. The samples may be those of a coarser surface. Throws SolveFailure.
 */
Eigen::MatrixXd ExtendBiharmonically(const Surface& surface, const EmbeddedSamples& samples);

/// Both: EmbedSamples' positions of samples, and ExtendBiharmonically to all points.
Eigen::MatrixXd EmbedBySmacof(
  const Surface& surface, const SmacofOptions& options = {}, const Progress& progress = {});

} // namespace shape
