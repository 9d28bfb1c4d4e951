#pragma once

#include "Base/Progress.h"
#include "Harmonic/ChargeSet.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <memory>

namespace shape
{

/// The derivative of a number F by the parameters of a charge set.
struct ChargeGradient
{
  Eigen::MatrixXd Charges;            ///< k x 3: d F / d ChargeSet::Charges
  Eigen::Matrix<double, 3, 4> Affine; ///< d F / d ChargeSet::Affine
};

/**
 * Computes the derivative of a number F by the charges and the affine part of a map f, whose
 * charges keep their positions. F depends on the images f(y_i) of points and on the Jacobians
 * there. The field is linear in the charges, so the derivative by charge j is the potential at its
 * position: sum_i g_i / (4 pi |y_i - x_j|), with g_i = d F / d f(y_i).
 *
 * points: n x 3, the y_i. byImages: n x 3, the g_i. byJacobians: n x 9, in the order of
 * EvaluateJacobians, or empty if F does not depend on the Jacobians. Throws InvalidInput if the
 * numbers of rows or columns do not match; Aborted.
 */
ChargeGradient ComputeChargeGradient(const ChargeSet& map, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& byImages, const Eigen::MatrixXd& byJacobians = {},
  const Progress& progress = {});

struct LinearVolumeMapOptions
{
  /// Root mean square residual of the fit, relative to the size of the image. > 0.
  double Tolerance = 1e-9;
  /// Relative residual of the transposed system. > 0. The relative error of the gradient is larger:
  /// 2.5e-6 with the default for bear_bis.
  double GradientTolerance = 1e-7;
  int MaximumIterations = 100; ///< of one solve; >= 1
};

/**
 * The harmonic map of a solid as a linear function of the images of its boundary points, and the
 * gradient of any function of the map by these images.
 *
 * ComputeHarmonicVolumeMap stops at a tolerance and refines the boundary where the residual is
 * large, so its charges do not depend linearly on the images. Here the charges are those of its
 * first level, one outside each boundary point and some farther out. They are fixed by square
 * equations: around each boundary point, the average residual is 0. The affine part is fitted
 * first. Both are linear in the images, and affine images give an exact map. The boundary is not
 * refined, so the error inside triangles may be larger than that of ComputeHarmonicVolumeMap.
 *
 * Let the fit be q = S b, with the images b and the charges q. The gradient of F(q) by b is
 * S^T d F / d q: one linear system with the transposed matrix, solved by the same fast sums from
 * the boundary to the charges. This is the adjoint method (Giles and Pierce, "An introduction to
 * the adjoint approach to design", Flow, Turbulence and Combustion 65, 2000). In terms of the
 * continuum, the gradient sweeps the derivative at inner points to the boundary: for F = f(y) it is
 * the harmonic measure of y. One gradient is by all images together. With the default tolerances,
 * it took 1.13 times the CPU time of a fit for bear_bis with 10096 points, and 0.96 times for
 * bunny00 with 37706 points. The transposed system may need more iterations, but the last of them
 * need less accurate sums.
 */
class LinearVolumeMap
{
public:
  /// boundary: as for ComputeHarmonicVolumeMap, whose exceptions are thrown.
  explicit LinearVolumeMap(const Surface& boundary, const LinearVolumeMapOptions& options = {},
    const Progress& progress = {});
  ~LinearVolumeMap();
  LinearVolumeMap(LinearVolumeMap&&) noexcept;
  LinearVolumeMap& operator=(LinearVolumeMap&&) noexcept;

  /// Returns the map with the given images of the boundary's points (n x 3). Throws InvalidInput if
  /// they are not finite or their number is wrong; SolveFailure if the iteration does not converge;
  /// Aborted.
  ChargeSet Fit(const Eigen::MatrixXd& images, const Progress& progress = {}) const;

  /// Returns the derivative of a number F by the images of the boundary's points (n x 3; 0 at
  /// points that no triangle uses). The arguments are those of ComputeChargeGradient; the points
  /// lie inside the boundary. Throws the exceptions of ComputeChargeGradient and Fit.
  Eigen::MatrixXd Gradient(const Eigen::MatrixXd& points, const Eigen::MatrixXd& byImages,
    const Eigen::MatrixXd& byJacobians = {}, const Progress& progress = {}) const;

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace shape
