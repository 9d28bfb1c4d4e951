#pragma once

#include "Core/Progress.h"

#include <Eigen/Core>
#include <memory>

namespace shape
{

struct FastSummationOptions
{
  enum class MethodType
  {
    Automatic, ///< the one that is expected to take less time
    Direct,    ///< pair by pair, DirectSummation.h: right to rounding
    Multipole
  };
  MethodType Method = MethodType::Automatic;
  /// Of the multipole method: the largest error of a potential, divided by the root mean square
  /// over the points of the potentials of the charges' absolute values. Of a gradient: the same, in
  /// units of the gradients of the absolute values. 1e-11 to 1e-2.
  double Tolerance = 1e-6;
};

/**
 * The potentials of point charges, phi(y_i) = sum_j q_j / (4 pi |y_i - x_j|), for many charges at
 * the same places, in time O(m + n).
 */
class FastSummation
{
public:
  /// sources: m x 3, the x_j; points: n x 3, the y_i. Throws InvalidInput where a coordinate is not
  /// finite or the tolerance is out of range, Aborted.
  FastSummation(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points,
    const FastSummationOptions& options = {}, const Progress& progress = {});
  ~FastSummation();
  FastSummation(FastSummation&&) noexcept;
  FastSummation& operator=(FastSummation&&) noexcept;

  /// charges: m x k, one column for each potential. Returns n x k. Throws InvalidInput, Aborted.
  Eigen::MatrixXd Potentials(const Eigen::MatrixXd& charges, const Progress& progress = {}) const;

  /// The gradients: n x 3k, column 3 r + c is d phi_r / d y_c. Throws InvalidInput, Aborted.
  Eigen::MatrixXd Gradients(const Eigen::MatrixXd& charges, const Progress& progress = {}) const;

private:
  struct Parts;
  std::unique_ptr<Parts> Self;
};

} // namespace shape
