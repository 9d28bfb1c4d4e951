#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>
#include <memory>

namespace shape
{

struct FmmSummationOptions
{
  enum class MethodType
  {
    Automatic, ///< the one that is expected to take less time
    Direct,    ///< pair by pair, DirectSummation.h: right to rounding
    Multipole
  };
  MethodType Method = MethodType::Automatic;
  /// Of the multipole method: the root mean square over the points of a potential's error, divided
  /// by that of the potential of the charges' absolute values. A single point's error is at most a
  /// hundred times as large, relative to the potential of the absolute values there; a gradient's,
  /// of the sum of |q| / (4 pi r^2), fifty times. MinimumTolerance to 0.1.
  double Tolerance = 1e-6;
  static constexpr double MinimumTolerance = 2e-12;
};

/**
 * The potentials of point charges, phi(y_i) = sum_j q_j / (4 pi |y_i - x_j|), for many sets of
 * charges at the same positions, in time O(m + n): a kernel-independent fast multipole method
 * (L. Ying, G. Biros, D. Zorin, J. Comput. Phys. 196, 2004; see FmmOperators.h and
 * FmmTree.h).
 *
 * This is the entry of the library shape_fmm, which has nothing to do with shapes: it needs Base
 * and Linear alone. Link shape_fmm, include this header, and
 *
 *     const shape::FmmSummation sum(sources, points);             // m x 3 and n x 3 coordinates
 *     const Eigen::MatrixXd potentials = sum.Potentials(charges); // of m x k charges: n x k
 *
 * Setting up costs about a third of a sum for tolerances down to 1e-6, and a sum and more beyond.
 * With Direct and with Multipole, a point's values are the same bits for any number of threads and
 * whichever points stand beside it, so points may be split between processes; they are not finite
 * if a point coincides with a source. Points may lie anywhere, sources in any arrangement.
 */
class FmmSummation
{
public:
  /// sources: m x 3, the x_j; points: n x 3, the y_i. Throws InvalidInput if a coordinate is not
  /// finite or the tolerance is out of range, Aborted.
  FmmSummation(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points,
    const FmmSummationOptions& options = {}, const Progress& progress = {});
  ~FmmSummation();
  FmmSummation(FmmSummation&&) noexcept;
  FmmSummation& operator=(FmmSummation&&) noexcept;

  /// charges: m x k, one column for each potential. Returns n x k. Throws InvalidInput, Aborted.
  Eigen::MatrixXd Potentials(const Eigen::MatrixXd& charges, const Progress& progress = {}) const;

  /// The gradients: n x 3k, column 3 r + c is d phi_r / d y_c. Throws InvalidInput, Aborted.
  Eigen::MatrixXd Gradients(const Eigen::MatrixXd& charges, const Progress& progress = {}) const;

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace shape
