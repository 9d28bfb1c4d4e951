#pragma once

#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Computes the heat kernel signature (Sun, Ovsjanikov and Guibas, "A concise and provably
 * informative multi-scale signature based on heat diffusion", 2009, equation 3). It is the heat
 * that remains at each point after some time, divided by the mean over the surface. At the
 * point x and the time t this is the sum of exp(-lambda t) phi(x)^2, divided by the sum of
 * exp(-lambda t), times the area. The signature is dimensionless, its area-weighted mean is 1, and
 * it does not depend on the size of the surface.
 *
 * Returns n x times. The times form a geometric sequence from 4 ln 10 / the largest eigenvalue to 4
 * ln 10 / the smallest nonzero one. The signature is 0 at points without a triangle. times: the
 * number of times; >= 1. Throws InvalidInput if all eigenvalues are 0.
 */
Eigen::MatrixXd ComputeHeatKernelSignature(const LaplaceEigenpairs& spectrum, int times = 100);

/**
 * Computes the wave kernel signature: the probability density, at each point, of a quantum particle
 * with about a given energy (Aubry, Schlickewei and Cremers, "The wave kernel signature", 2011,
 * equation 6), times the area. Its area-weighted mean is 1.
 *
 * Returns n x energies; 0 at points without a triangle. The logarithms of the energies are evenly
 * spaced from a + 2 s to b - 2 s. Here a and b are the logarithms of the smallest nonzero
 * eigenvalue and of the largest one. The standard deviation s is 0.07 (b - a). energies: the number
 * of energies; >= 1. Throws InvalidInput if all eigenvalues are 0.
 */
Eigen::MatrixXd ComputeWaveKernelSignature(const LaplaceEigenpairs& spectrum, int energies = 100);

/// Computes the wave kernel between each point x and the given point: phi(x) phi(point) replaces
/// phi(x)^2 in ComputeWaveKernelSignature. Returns n x energies. Two points that a symmetry of the
/// surface exchanges have different values, unless the symmetry maps `point` to itself.
Eigen::MatrixXd ComputeWaveKernelFrom(
  const LaplaceEigenpairs& spectrum, int point, int energies = 100);

/**
 * Computes the eigenfunctions of the smallest nonzero eigenvalues, each divided by the square root
 * of its eigenvalue (Rustamov, "Laplace-Beltrami eigenfunctions for deformation invariant shape
 * representation", 2007, section 4). Returns n x dimensions, dimensionless; bending the surface
 * changes it little. dimensions: >= 1. Throws InvalidInput if there are fewer nonzero eigenvalues.
 */
Eigen::MatrixXd ComputeSpectralEmbedding(const LaplaceEigenpairs& spectrum, int dimensions);

} // namespace shape
