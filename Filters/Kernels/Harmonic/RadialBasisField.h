#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

struct RadialBasisOptions
{
  enum class KernelType
  {
    /// (1 - r)^4 (4 r + 1) for r < 1, else 0 (Wendland, "Piecewise polynomial, positive definite
    /// and compactly supported radial functions of minimal degree", 1995, C2)
    Wendland = 0,
    ThinPlate = 1 ///< r^2 log r
  };
  KernelType Kernel = KernelType::Wendland;
  /// Wendland: the distance at which a centre has no effect any more, relative to the longest side
  /// of the points' box. > 0.
  double SupportRadius = 0.5;
  /// Centres are added until the largest error is at most this share of the largest value. >= 0.
  double Tolerance = 1e-3;
  int MaximumCentres = 1000; ///< >= 1
};

/// Throws InvalidInput if an option is out of range.
void RequireValid(const RadialBasisOptions& options);

/// A field of radial basis functions and an affine part, with three values.
struct RadialBasisField
{
  Eigen::MatrixXd Centres = Eigen::MatrixXd(0, 3);                          ///< k x 3
  Eigen::MatrixXd Weights = Eigen::MatrixXd(0, 3);                          ///< k x 3
  Eigen::Matrix<double, 3, 4> Affine = Eigen::Matrix<double, 3, 4>::Zero(); ///< [A b]
  RadialBasisOptions::KernelType Kernel = RadialBasisOptions::KernelType::Wendland;
  double Radius = 1.0;       ///< the length that distances are divided by
  double MaximumError = 0.0; ///< at the points of the fit, relative to the largest value
};

/**
 * Interpolates values at some of the given points, which are chosen greedily: in each round the
 * field interpolates the values at its centres, and the points with the largest errors become
 * further centres (T. C. S. Rendall and C. B. Allen, "Efficient mesh motion using radial basis
 * functions with data reduction algorithms", 2009). Affine values are reproduced exactly.
 *
 * points: n x 3, n >= 1, finite. values: n x 3, finite. Throws InvalidInput if an option is out of
 * range; SolveFailure if the system is singular; Aborted.
 */
RadialBasisField FitRadialBasis(const Eigen::MatrixXd& points, const Eigen::MatrixXd& values,
  const RadialBasisOptions& options = {}, const Progress& progress = {});

/// Returns the values of the field at `points` (n x 3). Throws Aborted.
Eigen::MatrixXd Evaluate(
  const RadialBasisField& field, const Eigen::MatrixXd& points, const Progress& progress = {});

} // namespace shape
