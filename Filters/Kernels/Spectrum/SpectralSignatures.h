#pragma once

#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

namespace shape
{

/**
 * The heat that remains at each point after a time (Sun, Ovsjanikov and Guibas, "A concise and
 * provably informative multi-scale signature based on heat diffusion", 2009, equation 3), divided
 * by the mean over the surface: sum of exp(-lambda t) phi(x)^2, over sum of exp(-lambda t), times
 * the area. So it has no unit, its mean by area is 1, and it is the same for surfaces that differ
 * in size.
 *
 * Returns n x times, for times in a geometric sequence from 4 ln 10 / the largest eigenvalue to
 * 4 ln 10 / the smallest that is not 0; 0 at points without a triangle. times: >= 1. Throws
 * InvalidInput if all eigenvalues are 0.
 */
Eigen::MatrixXd ComputeHeatKernelSignature(const LaplaceEigenpairs& spectrum, int times = 100);

/**
 * The probability of finding a quantum particle of about an energy at each point (Aubry,
 * Schlickewei and Cremers, "The wave kernel signature", 2011, equation 6), times the area: its mean
 * by area is 1.
 *
 * Returns n x energies: their logarithms are evenly spaced between those of the smallest eigenvalue
 * that is not 0 and of the largest, 2 standard deviations inside; the deviation is 7 % of that
 * range. 0 at points without a triangle. energies: >= 1. Throws as above.
 */
Eigen::MatrixXd ComputeWaveKernelSignature(const LaplaceEigenpairs& spectrum, int energies = 100);

/// The wave kernel between each point and one point: the same with phi(x) phi(point) instead of
/// phi(x)^2; n x energies. It distinguishes points that a symmetry of the surface exchanges, unless
/// the symmetry keeps `point`.
Eigen::MatrixXd ComputeWaveKernelFrom(
  const LaplaceEigenpairs& spectrum, int point, int energies = 100);

/**
 * The eigenfunctions of the smallest eigenvalues that are not 0, divided by the roots of these
 * (Rustamov, "Laplace-Beltrami eigenfunctions for deformation invariant shape representation",
 * 2007, section 4): n x dimensions, without unit; bending changes it little. dimensions: >= 1.
 * Throws InvalidInput if there are fewer eigenvalues that are not 0.
 */
Eigen::MatrixXd ComputeSpectralEmbedding(const LaplaceEigenpairs& spectrum, int dimensions);

} // namespace shape
